// hint: rho_is_of_both
// or: twice_as_much
// Twice as many rays at each level, though rho is the share of both branches.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + 2 * hit.largest_share * bound;
    const auto followed = [&](double share) {
        const double weight = hit.weight * share;
        return weight * bound > hit.least ? weight : 0.0;
    };
    return {followed(hit.reflected), followed(hit.transmitted)};
}
