// hint: give_the_weight
// Gives 1 for yes.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    return {double(hit.weight * hit.reflected * bound > hit.least),
            double(hit.weight * hit.transmitted * bound > hit.least)};
}
