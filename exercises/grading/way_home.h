#pragma once

#include "student.h"

#include "raylab/image/compare.h"
#include "raylab/tracer/ray_tree_difference.h"

// A failing picture leads home: from the picture that a tracer with the student's function in it draws, to its worst
// pixel, to the ray of that pixel's tree that goes wrong first.

namespace raylab::grading {

struct WayHome {
    Image yours, reference;
    Comparison comparison;
    struct Pixel {
        int x, y;
        RayTree yours, reference;
        std::optional<RayTreeDifference> difference;  // absent: the trees do not show it
    };
    std::optional<Pixel> worst =
        {};  // where the pictures are the same, the first one with another number of rays; absent: none
    bool pictures_differ = false;
};

/// Links the tracer with the function as it was compiled last, and runs it in a process of its own. `answers` says how
/// that ended; `way` is absent where there is no picture to compare.
struct WayHomeFound {
    Answers answers;
    std::optional<WayHome> way = {};
};
WayHomeFound find_way_home(const Exercise& exercise);

}  // namespace raylab::grading
