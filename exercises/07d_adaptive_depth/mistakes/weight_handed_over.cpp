// hint: each_keeps_its_own
// A branch that is followed alone takes over the weight of the other one.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    const double reflected = hit.weight * hit.reflected, transmitted = hit.weight * hit.transmitted;
    const bool first = reflected * bound > hit.least, second = transmitted * bound > hit.least;
    if (first && second) return {reflected, transmitted};
    return {first ? reflected + transmitted : 0, second ? reflected + transmitted : 0};
}
