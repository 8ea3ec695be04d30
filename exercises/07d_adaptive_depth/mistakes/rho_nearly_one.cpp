// hint: rho_is_one
// Keeps rho off 1, so that nothing is divided by 0.
#include "raylab/tracer/followed_branches.h"

#include <algorithm>
#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = std::min(hit.largest_share, 0.9999);
    const double bound = hit.brightest * (1 - std::pow(rho, hit.levels)) / (1 - rho);
    const auto worth = [&](double w) { return w * bound > hit.least ? w : 0; };
    return {worth(hit.weight * hit.reflected), worth(hit.weight * hit.transmitted)};
}
