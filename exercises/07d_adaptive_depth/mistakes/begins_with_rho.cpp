// hint: first_term
// rho + rho^2 + ...
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double term = 1, sum = 0;
    for (int i = 0; i < hit.levels; ++i) {
        term *= hit.largest_share;
        sum += term;
    }
    const double bound = sum * hit.brightest;
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    return {r * bound > hit.least ? r : 0, t * bound > hit.least ? t : 0};
}
