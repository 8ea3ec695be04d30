// hint: more_than_the_least
// Leaves out what brings less.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double sum = 0, term = hit.brightest;
    for (int i = hit.levels; i > 0; --i, term *= hit.largest_share) sum += term;
    FollowedBranches followed{hit.weight * hit.reflected, hit.weight * hit.transmitted};
    if (followed.reflected * sum < hit.least) followed.reflected = 0;
    if (followed.transmitted * sum < hit.least) followed.transmitted = 0;
    return followed;
}
