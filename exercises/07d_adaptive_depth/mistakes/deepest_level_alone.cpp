// hint: last_term
// or: one_level
// L rho^(n - 1).
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    if (hit.levels == 0) return {};
    const double bound = hit.brightest * std::pow(hit.largest_share, hit.levels - 1);
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    return {r * bound > hit.least ? r : 0, t * bound > hit.least ? t : 0};
}
