// Turns the comparison: the least, divided by what a ray of weight 1 can bring.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    if (hit.levels == 0) return {};
    double terms = 0, term = 1;
    for (int i = 0; i < hit.levels; ++i, term *= hit.largest_share) terms += term;
    const double needed = hit.least / (hit.brightest * terms);
    FollowedBranches followed{hit.weight * hit.reflected, hit.weight * hit.transmitted};
    if (!(followed.reflected > needed)) followed.reflected = 0;
    if (!(followed.transmitted > needed)) followed.transmitted = 0;
    return followed;
}
