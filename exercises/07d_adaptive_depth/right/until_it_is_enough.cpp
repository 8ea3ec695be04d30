// Adds up until it is enough, or no level is left.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const auto followed = [&](double share) {
        double sum = 0, term = hit.weight * share * hit.brightest;
        for (int i = 0; i < hit.levels; ++i) {
            sum += term;
            if (sum > hit.least) return hit.weight * share;
            term *= hit.largest_share;
        }
        return 0.0;
    };
    return {.reflected = followed(hit.reflected), .transmitted = followed(hit.transmitted)};
}
