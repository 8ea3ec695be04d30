// hint: rho_is_one
// Where rho is 1 the quotient is 0 / 0.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.largest_share;
    const double bound = hit.brightest * (1 - std::pow(rho, hit.levels)) / (1 - rho);
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    return {r * bound > hit.least ? r : 0, t * bound > hit.least ? t : 0};
}
