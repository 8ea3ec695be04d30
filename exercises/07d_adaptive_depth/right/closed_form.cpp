// The geometric series.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.largest_share, n = hit.levels;
    const double bound = hit.brightest * (rho < 1 ? (1 - std::pow(rho, n)) / (1 - rho) : n);
    const auto worth = [&](double share) {
        const double w = hit.weight * share;
        return w * bound > hit.least ? w : 0;
    };
    return {worth(hit.reflected), worth(hit.transmitted)};
}
