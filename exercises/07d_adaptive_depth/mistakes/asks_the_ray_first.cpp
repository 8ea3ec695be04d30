// hint: weight_alone
// Gives up where the arriving ray weighs less than the least, however bright the scene is.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    if (hit.weight <= hit.least) return {0, 0};
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    const double reflected = hit.weight * hit.reflected, transmitted = hit.weight * hit.transmitted;
    return {reflected * bound > hit.least ? reflected : 0, transmitted * bound > hit.least ? transmitted : 0};
}
