// hint: own_least
// Adds up levels until one brings less than a thousandth.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0, brings = hit.brightest;
    for (int left = hit.levels; left > 0 && brings >= 1e-3; --left) {
        bound += brings;
        brings *= hit.largest_share;
    }
    const auto followed = [&](double weight) { return weight * bound > hit.least ? weight : 0.0; };
    return {followed(hit.weight * hit.reflected), followed(hit.weight * hit.transmitted)};
}
