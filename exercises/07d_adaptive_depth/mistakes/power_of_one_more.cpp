// hint: count_the_levels
// 1 - rho^(n + 1).
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.largest_share;
    const double terms = rho == 1 ? hit.levels + 1 : (1 - std::pow(rho, hit.levels + 1)) / (1 - rho);
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    FollowedBranches followed;
    if (r * hit.brightest * terms > hit.least) followed.reflected = r;
    if (t * hit.brightest * terms > hit.least) followed.transmitted = t;
    return followed;
}
