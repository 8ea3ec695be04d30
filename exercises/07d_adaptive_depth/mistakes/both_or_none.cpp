// hint: each_by_itself
// By what both bring together.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    if (!(hit.weight * (hit.reflected + hit.transmitted) * bound > hit.least)) return {};
    return {hit.weight * hit.reflected, hit.weight * hit.transmitted};
}
