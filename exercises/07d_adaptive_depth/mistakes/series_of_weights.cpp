// hint: brightest
// Adds up weights, and no colours.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const auto worth = [&](double share) {
        double all = 0;
        for (int i = 0; i < hit.levels; ++i) all += hit.weight * share * std::pow(hit.largest_share, i);
        return all > hit.least ? hit.weight * share : 0;
    };
    return {worth(hit.reflected), worth(hit.transmitted)};
}
