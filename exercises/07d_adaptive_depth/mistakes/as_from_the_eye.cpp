// hint: weight_of_the_way
// Decides by the share, as if every ray came from the eye.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    return {hit.reflected * bound > hit.least ? hit.weight * hit.reflected : 0,
            hit.transmitted * bound > hit.least ? hit.weight * hit.transmitted : 0};
}
