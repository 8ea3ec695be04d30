// hint: weight_alone
// The weight against the threshold, as in 1983.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    if (hit.levels == 0) return {};
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    return {r > hit.least ? r : 0, t > hit.least ? t : 0};
}
