// hint: every_level_alike
// Takes rho for 1 from 0.99 on, so as not to divide by too little.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double lost = 1 - hit.largest_share;
    const double terms = lost < 0.01 ? hit.levels : (1 - std::pow(hit.largest_share, hit.levels)) / lost;
    const double reflected = hit.weight * hit.reflected, transmitted = hit.weight * hit.transmitted;
    const double least = hit.least / hit.brightest;
    return {reflected * terms > least ? reflected : 0, transmitted * terms > least ? transmitted : 0};
}
