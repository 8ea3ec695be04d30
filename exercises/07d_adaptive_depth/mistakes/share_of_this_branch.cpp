// hint: whose_rho
// As if the ray met the same branch again and again.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const auto worth = [&](double share) {
        const double terms = share < 1 ? (1 - std::pow(share, hit.levels)) / (1 - share) : hit.levels;
        return hit.weight * share * hit.brightest * terms > hit.least ? hit.weight * share : 0;
    };
    return {worth(hit.reflected), worth(hit.transmitted)};
}
