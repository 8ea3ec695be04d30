#pragma once

#include "student.h"

#include "raylab/image/compare.h"
#include "raylab/report/ray_tree/ray_tree_difference.h"

// Leads from a wrong picture to its cause: from the picture drawn by a tracer with the student's function, to its worst
// pixel, to the first ray of that pixel's tree that goes wrong.

namespace raylab::grading {

struct WayHome {
    Image yours, reference;
    Comparison comparison;
    struct Pixel {
        int x, y;
        RayTree yours, reference;
        std::optional<RayTreeDifference> difference;  // absent where the trees are equal
    };
    std::optional<Pixel> worst =
        {};  // where the pictures are equal, the first pixel with another number of rays; absent: none
    bool pictures_differ = false;
};

/// Links the tracer with the function as it was compiled, and runs it in a process of its own. `answers` says how
/// that ended; `way` is absent where there is no picture to compare.
struct WayHomeFound {
    Answers answers;
    std::optional<WayHome> way = {};
};
WayHomeFound find_way_home(const Exercise& exercise, const Workplace& workplace);

}  // namespace raylab::grading
