// hint: one_level
// The next surface's own colour, and nothing that follows.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    if (hit.levels == 0) return {};
    const auto worth = [&](double share) {
        const double w = hit.weight * share;
        return w * hit.brightest > hit.least ? w : 0;
    };
    return {worth(hit.reflected), worth(hit.transmitted)};
}
