// hint: last_term
// or: one_level
// The colour is dimmed by rho for each level.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    if (hit.levels == 0) return {};
    double bound = hit.brightest;
    for (int i = 0; i < hit.levels; ++i) bound *= hit.largest_share;
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    return {r * bound > hit.least ? r : 0, t * bound > hit.least ? t : 0};
}
