// hint: first_term
// Multiplies the bound by rho, which stands for the branch's share.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.largest_share, n = hit.levels;
    const double bound = hit.brightest * rho * (rho < 1 ? (1 - std::pow(rho, n)) / (1 - rho) : n);
    const auto worth = [&](double share) { return hit.weight * share * bound > hit.least ? hit.weight * share : 0; };
    return {worth(hit.reflected), worth(hit.transmitted)};
}
