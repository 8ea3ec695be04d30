// hint: counted_twice
// The bound has the weight of the arriving ray in it, and so has the branch.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.weight * hit.brightest + hit.largest_share * bound;
    const auto followed = [&](double weight) { return weight * bound > hit.least ? weight : 0.0; };
    return {followed(hit.weight * hit.reflected), followed(hit.weight * hit.transmitted)};
}
