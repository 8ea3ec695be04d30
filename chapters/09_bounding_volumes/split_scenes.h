#pragma once

#include "raylab/experiment/structure/structure_workload.h"
#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::volumes {

/// A scene with rays of its camera, and with rays from anywhere to anywhere.
struct SplitScene {
    std::string name;
    StructureWorkload camera, incoherent;
};

/// The knot, the knot between a hundred taut wires, and straws alone: long thin triangles at all angles.
std::vector<SplitScene> split_scenes(const ChapterRun& run);

/// The bunny and the elephant, where they have been fetched.
std::vector<SplitScene> real_split_scenes(const ChapterRun& run);

}  // namespace raylab::volumes
