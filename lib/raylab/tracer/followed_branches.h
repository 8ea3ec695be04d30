#pragma once

namespace raylab {

/// A surface where a ray branches, and what is known of the whole scene before its branches are traced.
struct BranchingHit {
    double weight;                  // of the ray that arrives: its share of the pixel; 1 for the eye ray
    double reflected, transmitted;  // the shares of what a mirrored and a refracted ray bring; 0: there is no such ray
    int levels;                     // so many rays may still follow one another from here on, no more; 0: none
    double brightest;               // no surface's own colour and no background is brighter than this
    double largest_share;           // no surface's two shares are more than this together; at most 1
    double least;                   // what a pixel may lose by a branch that is not followed
};

/// The weights with which the rays are traced; 0: that ray is not followed.
struct FollowedBranches {
    double reflected = 0, transmitted = 0;
};

/// Adaptive depth control: a branch is followed only if all that it can still bring, down to the last level, may change
/// the pixel by more than the least. (R. Hall, D. Greenberg: A Testbed for Realistic Image Synthesis, IEEE CG&A 3(8),
/// 1983, who compare its weight alone.)
FollowedBranches followed_branches(const BranchingHit& hit);

}  // namespace raylab
