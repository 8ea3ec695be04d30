// hint: visit_twice
// Each half is visited with its chance, and pays for it; the node itself does not.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const auto faces = [](const Vec3d& box) { return 2 * (box.x * box.y + box.y * box.z + box.z * box.x); };
    const double of_cell = faces(cut.size);
    if (of_cell == 0) return std::numeric_limits<double>::infinity();
    const double test = cut.test_cost * (cut.below == 0 || cut.above == 0 ? 1 - cut.empty_bonus : 1);
    const auto half = [&](double height, double things) {
        Vec3d box = cut.size;
        box[cut.axis] = height;
        return faces(box) / of_cell * (cut.visit_cost + things * test);
    };
    return half(cut.place, cut.below) + half(cut.size[cut.axis] - cut.place, cut.above);
}
