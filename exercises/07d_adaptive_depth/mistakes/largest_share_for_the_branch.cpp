// hint: share_of_the_branch
// The branch's own share is left out of the comparison.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.largest_share, n = hit.levels;
    const double bound = hit.weight * hit.brightest * (rho < 1 ? (1 - std::pow(rho, n)) / (1 - rho) : n);
    const auto worth = [&](double share) { return share > 0 && bound > hit.least ? hit.weight * share : 0; };
    return {worth(hit.reflected), worth(hit.transmitted)};
}
