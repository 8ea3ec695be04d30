// hint: count_the_levels
// or: one_level
// Subtracts the level that the ray itself takes.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int left = hit.levels - 1; left > 0; --left) bound = hit.brightest + hit.largest_share * bound;
    const auto worth = [&](double w) { return w * bound > hit.least ? w : 0; };
    return {worth(hit.weight * hit.reflected), worth(hit.weight * hit.transmitted)};
}
