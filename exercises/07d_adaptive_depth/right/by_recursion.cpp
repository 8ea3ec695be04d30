// The most that a ray with so many levels brings, by itself.
#include "raylab/tracer/followed_branches.h"

namespace {

double brightest_ray(double own, double rho, int levels) {
    return levels <= 0 ? 0 : own + rho * brightest_ray(own, rho, levels - 1);
}

}  // namespace

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double most = brightest_ray(hit.brightest, hit.largest_share, hit.levels);
    const double r = hit.reflected * hit.weight, t = hit.transmitted * hit.weight;
    if (r * most > hit.least && t * most > hit.least) return {r, t};
    if (r * most > hit.least) return {r, 0};
    if (t * most > hit.least) return {0, t};
    return {0, 0};
}
