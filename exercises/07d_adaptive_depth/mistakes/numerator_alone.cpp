// hint: undivided
// 1 - rho^n, and not over 1 - rho.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double bound = hit.brightest * (1 - std::pow(hit.largest_share, hit.levels));
    const auto followed = [&](double weight) { return weight * bound > hit.least ? weight : 0.0; };
    return {followed(hit.weight * hit.reflected), followed(hit.weight * hit.transmitted)};
}
