// hint: every_level_alike
// L n.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double bound = hit.brightest * hit.levels;
    const double r = hit.weight * hit.reflected, t = hit.weight * hit.transmitted;
    return {r * bound > hit.least ? r : 0, t * bound > hit.least ? t : 0};
}
