// hint: one_level
// or: no_level_left
// The same, and no last level.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double needed = hit.least / hit.brightest;
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    return {r > needed ? r : 0, t > needed ? t : 0};
}
