// hint: weight_of_the_way
// Allows a loss relative to the ray's own weight.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.largest_share;
    const double terms = rho == 1 ? hit.levels : (1 - std::pow(rho, hit.levels)) / (1 - rho);
    const auto worth = [&](double w) { return w * hit.brightest * terms > hit.least * hit.weight ? w : 0; };
    return {worth(hit.weight * hit.reflected), worth(hit.weight * hit.transmitted)};
}
