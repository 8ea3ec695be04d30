// hint: endless
// 1 / (1 - rho), and the levels where that has no value.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    const double rho = hit.largest_share;
    const double sum = rho < 1 ? 1 / (1 - rho) : hit.levels;
    const auto follow = [&](double share) {
        const double weight = hit.weight * share;
        return weight * hit.brightest * sum > hit.least ? weight : 0.0;
    };
    return {follow(hit.reflected), follow(hit.transmitted)};
}
