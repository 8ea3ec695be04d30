// hint: own_least
// A ray with less than a thousandth of the pixel is never followed.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    const auto followed = [&](double weight) { return weight > 1e-3 && weight * bound > hit.least ? weight : 0.0; };
    return {followed(hit.weight * hit.reflected), followed(hit.weight * hit.transmitted)};
}
