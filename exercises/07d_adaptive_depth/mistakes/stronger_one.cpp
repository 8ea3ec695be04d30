// hint: each_by_itself
// One ray goes on.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    if (r >= t) return {r * bound > hit.least ? r : 0, 0};
    return {0, t * bound > hit.least ? t : 0};
}
