#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const auto& [weight, reflected, transmitted, levels, brightest, rho, least] = hit;
    // B = L (1 + rho + ... + rho^(levels - 1)), a geometric series; where all is mirrored, every level adds the same.
    const double series = rho == 1 ? levels : (1 - std::pow(rho, levels)) / (1 - rho);
    const auto followed = [&](double share) {
        return weight * share * brightest * series > least ? weight * share : 0;
    };
    return {followed(reflected), followed(transmitted)};
}
