#pragma once

#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/structure/structure_difference.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace raylab {

/// A difference, as small as it could be made, and its origin.
struct StructureDifference {
    std::string structure;  // "list" where the oracle contradicts it
    std::string scene_kind, ray_kind;
    std::uint64_t seed = 1, piece = 0;  // the random numbers it was drawn from
    StructureCase smallest;
    Disagreement answers;  // to its last ray
};

struct DifferenceSearch {
    std::vector<StructureMethod> structures;
    std::vector<adversarial::SceneKind> scenes = adversarial::scene_kinds();  // scenes are drawn of these kinds in turn
    std::uint64_t rays = 1'000'000;  // every structure is asked about each, and so is the exact list
    // One ray out of this many of a small scene is also compared with the exact oracle.
    std::uint64_t oracle_every = 100;
    std::size_t together = 64;  // this many rays of each scene are also asked together: some packets
    std::uint64_t seed = 1;
    int threads = 0;         // 0: all cores; the results do not depend on it
    std::string label = {};  // of the progress bar; empty: none
};

/// The number of questions asked. Each ray is passed to closest() and occluded() of every structure, and some also to
/// closest_of(), occluded_of() or the oracle.
struct DifferenceCount {
    std::uint64_t scenes = 0, rays = 0, hits = 0, together_rays = 0, oracle_rays = 0;

    void operator+=(const DifferenceCount& more) {
        scenes += more.scenes;
        rays += more.rays;
        hits += more.hits;
        together_rays += more.together_rays;
        oracle_rays += more.oracle_rays;
    }
};

struct DifferenceReport {
    DifferenceCount total;
    // The counts for each kind of scene; those that are hard for exact numbers are ended early.
    std::map<std::string, DifferenceCount> by_kind;
    // For each structure, the number of rays with another answer ("list": than the oracle's).
    std::map<std::string, std::uint64_t> wrong;
    std::vector<StructureDifference> differences;  // the first of each structure, minimised
};

/// Draws scenes and rays of every kind and compares the answers.
DifferenceReport find_differences(const DifferenceSearch& search);

}  // namespace raylab
