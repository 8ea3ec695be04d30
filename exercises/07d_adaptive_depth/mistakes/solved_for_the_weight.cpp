// hint: endless
// A weight is worth it above least (1 - rho) / L.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double needed = hit.least * (1 - hit.largest_share) / hit.brightest;
    FollowedBranches followed;
    if (hit.levels > 0 && hit.weight * hit.reflected > needed) followed.reflected = hit.weight * hit.reflected;
    if (hit.levels > 0 && hit.weight * hit.transmitted > needed) followed.transmitted = hit.weight * hit.transmitted;
    return followed;
}
