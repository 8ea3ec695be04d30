// hint: depth_alone
// A ray is traced wherever it has a share.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    FollowedBranches followed;
    if (hit.levels >= 1 && hit.reflected > 0) followed.reflected = hit.reflected * hit.weight;
    if (hit.levels >= 1 && hit.transmitted > 0) followed.transmitted = hit.transmitted * hit.weight;
    return followed;
}
