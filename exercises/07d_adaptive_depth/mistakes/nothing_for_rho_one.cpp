// hint: rho_is_one
// Avoids the division, and forgets the sum.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.largest_share;
    double terms = hit.levels > 0 ? 1 : 0;
    if (rho < 1) terms = (std::pow(rho, hit.levels) - 1) / (rho - 1);
    const auto worth = [&](double w) { return w * terms * hit.brightest <= hit.least ? 0 : w; };
    if (rho >= 1) return {};
    return {worth(hit.weight * hit.reflected), worth(hit.weight * hit.transmitted)};
}
