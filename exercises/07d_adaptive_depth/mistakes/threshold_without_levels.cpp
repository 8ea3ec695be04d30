// hint: weight_alone
// The same, and no last level.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    FollowedBranches followed{hit.weight * hit.reflected, hit.weight * hit.transmitted};
    if (followed.reflected <= hit.least) followed.reflected = 0;
    if (followed.transmitted <= hit.least) followed.transmitted = 0;
    return followed;
}
