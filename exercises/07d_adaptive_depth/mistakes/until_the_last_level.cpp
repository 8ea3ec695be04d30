// hint: depth_alone
// Depth control.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    if (hit.levels == 0) return {};
    return {hit.weight * hit.reflected, hit.weight * hit.transmitted};
}
