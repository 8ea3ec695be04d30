// hint: twice_as_much
// Each of two branches may lose half of the least.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    const auto followed = [&](double weight) { return weight * bound > hit.least / 2 ? weight : 0.0; };
    return {followed(hit.weight * hit.reflected), followed(hit.weight * hit.transmitted)};
}
