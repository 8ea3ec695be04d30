// hint: whose_rho
// rho is what this surface passes on.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.reflected + hit.transmitted;
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + rho * bound;
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    return {r * bound > hit.least ? r : 0, t * bound > hit.least ? t : 0};
}
