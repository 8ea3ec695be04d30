#pragma once

#include "raylab/accelerator/adversarial/adversarial_scenes.h"
#include "raylab/report/structure/structure_difference.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace raylab {

/// A difference, as small as it could be made, and where it came from.
struct StructureDifference {
    std::string structure;  // "list" where the oracle contradicts it
    std::string scene_kind, ray_kind;
    std::uint64_t seed = 1, piece = 0;  // what was drawn from
    StructureCase least;
    Disagreement answers;  // to its last ray
};

struct DifferenceSearch {
    std::vector<StructureMethod> structures;
    std::vector<adversarial::SceneKind> scenes = adversarial::scene_kinds();  // of these kinds in turn
    std::uint64_t rays = 1'000'000;     // each asked of every structure, and of the exact list
    std::uint64_t oracle_every = 100;   // every so-manieth ray of a small scene is asked of the exact oracle, too
    std::size_t together = 64;          // so many rays of each scene are asked of closest_of(), too: some packets
    std::uint64_t seed = 1;
    int threads = 0;                    // 0: all cores; what is found is the same for any number
    std::string label = {};             // of the progress bar; empty: none
};

/// What was asked. Each ray: closest() and occluded() of every structure; some of them closest_of() or the oracle, too.
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
    std::map<std::string, DifferenceCount> by_kind;  // of scene: those that are hard on exact numbers are left early
    std::map<std::string, std::uint64_t> wrong;     // by structure: rays answered otherwise ("list": by the oracle)
    std::vector<StructureDifference> differences;  // the first of each structure, minimised
};

/// Draws scenes of every kind and rays of every kind through them, and asks.
DifferenceReport find_differences(const DifferenceSearch& search);

}  // namespace raylab
