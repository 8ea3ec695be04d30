// hint: share_of_the_branch
// Decides by the weight of the ray that has arrived.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    if (!(hit.weight * bound > hit.least)) return {};
    return {hit.weight * hit.reflected, hit.weight * hit.transmitted};
}
