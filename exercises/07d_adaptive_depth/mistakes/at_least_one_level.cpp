// hint: no_level_left
// Takes no level for one.
#include "raylab/tracer/followed_branches.h"

#include <algorithm>
#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const int n = std::max(hit.levels, 1);
    const double rho = hit.largest_share, terms = rho == 1 ? n : (1 - std::pow(rho, n)) / (1 - rho);
    const auto worth = [&](double w) { return w * hit.brightest * terms > hit.least ? w : 0; };
    return {worth(hit.weight * hit.reflected), worth(hit.weight * hit.transmitted)};
}
