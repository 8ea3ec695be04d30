// hint: every_level_alike
// The loop adds up and forgets the factor.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound += hit.brightest;
    FollowedBranches followed{hit.weight * hit.reflected, hit.weight * hit.transmitted};
    if (!(followed.reflected * bound > hit.least)) followed.reflected = 0;
    if (!(followed.transmitted * bound > hit.least)) followed.transmitted = 0;
    return followed;
}
