// hint: each_by_itself
// Both, if one of them is worth it.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    if (r * bound > hit.least || t * bound > hit.least) return {r, t};
    return {};
}
