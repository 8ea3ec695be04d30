#pragma once

#include "arguments.h"
#include "marbles.h"
#include "work_task.h"

#include "raylab/accelerator/split_tree/kd_tree.h"

#include <array>

// The counted work: rays traverse the lab's kd-tree, which is split where sah_cost() is lowest.

namespace raylab::grading::cuts {

/// The work of the rays in a tree over marbles in a cube of that side. A cut whose cost is NaN is never made.
inline Worked cost_among_marbles(double side, const Answer& sah_cost, const std::vector<Ray>& rays) {
    const Scene scene = marbles(250, side);
    const SahCosts costs{.visit = 1.5, .test = 1, .empty_bonus = 0.1};  // the fastest for the lab's own trees
    const KdTree tree(scene, surface_area_heuristic(costs, [&](const SahCut& cut) {
                          std::array<double, outputs> said{};
                          sah_cost(as_input(cut), said);
                          return said[0];
                      }));
    Traversal traversal;
    Worked worked;
    for (const Ray& ray : rays) {
        const auto hit = tree.closest(ray, traversal);
        worked.hits.push_back(hit ? std::optional(hit->primitive) : std::nullopt);
    }
    worked.work = costs.visit * static_cast<double>(traversal.steps) +
                  costs.test * static_cast<double>(traversal.primitive_tests);
    return worked;
}

inline WorkTask in_cube(const std::string& name, double side) {
    Dice dice(12);
    std::vector<Ray> rays;
    for (int i = 0; i < 200; ++i) {
        const Vec3d from = dice.point(-1, 2), to = dice.point(0.1, 0.9);
        rays.push_back({convert<float>(from * side), convert<float>(to - from)});
    }
    return {name, "tests a ray (a visit counts 1.5)",
            [side, rays](const Answer& sah_cost) { return cost_among_marbles(side, sah_cost, rays); }};
}

inline std::vector<WorkTask> work_tasks() {
    return {in_cube("marbles in a bag of a metre", 1), in_cube("marbles in a bag of a nanometre", 1e-9)};
}

}  // namespace raylab::grading::cuts
