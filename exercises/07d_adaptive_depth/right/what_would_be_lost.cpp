// What the pixel loses if the branch is left out.
#include "raylab/tracer/followed_branches.h"

#include <cmath>

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    FollowedBranches followed;
    const int n = hit.levels;
    for (double FollowedBranches::*branch : {&FollowedBranches::reflected, &FollowedBranches::transmitted}) {
        const double share = branch == &FollowedBranches::reflected ? hit.reflected : hit.transmitted;
        long double lost = 0;
        for (int level = 0; level < n; ++level)
            lost += share * hit.brightest * std::pow(static_cast<long double>(hit.largest_share), level);
        if (lost * hit.weight > hit.least) followed.*branch = share * hit.weight;
    }
    return followed;
}
