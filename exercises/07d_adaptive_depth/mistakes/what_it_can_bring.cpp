// hint: give_the_weight
// Gives the bound.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.largest_share, n = hit.levels;
    const double bound = hit.weight * hit.brightest * (rho < 1 ? (1 - std::pow(rho, n)) / (1 - rho) : n);
    const double r = hit.reflected * bound, t = hit.transmitted * bound;
    return {r > hit.least ? r : 0, t > hit.least ? t : 0};
}
