// hint: each_by_itself
// What the mirrored branch has lost the refracted one may not lose any more.
#include "raylab/tracer/followed_branches.h"

raylab::FollowedBranches raylab::followed_branches(const BranchingHit& hit) {
    double bound = 0;
    for (int i = 0; i < hit.levels; ++i) bound = hit.brightest + hit.largest_share * bound;
    const double mirrored = hit.weight * hit.reflected, refracted = hit.weight * hit.transmitted;
    const bool is_mirrored = mirrored * bound > hit.least;
    const double left = is_mirrored ? hit.least : hit.least - mirrored * bound;
    return {is_mirrored ? mirrored : 0, refracted * bound > left ? refracted : 0};
}
