#pragma once

#include "arguments.h"
#include "marbles.h"
#include "work_task.h"

#include "raylab/experiment/textbook/textbook_octree.h"

#include <array>

// The counted work: rays go through an octree of marbles, from point to point by point_in_next_cell().

namespace raylab::grading::next_cell {

inline WorkTask through_marbles(const std::string& name, const std::vector<Ray>& rays) {
    return {name, "cells a ray", [rays](const Answer& point_in_next_cell) {
                Worked worked;
                const Scene scene = marbles(300, 16);
                const TextbookOctree tree(scene, [&](const OctreeCube& cube, double smallest_cell, const Vec3d& origin,
                                                     const Vec3d& direction) {
                    ++worked.work;
                    std::array<double, outputs> said{};
                    point_in_next_cell(as_input({cube, smallest_cell, origin, direction}), said);
                    return Vec3d{said[0], said[1], said[2]};
                });
                Traversal traversal;
                for (const Ray& ray : rays) {
                    const auto hit = tree.closest(ray, traversal);
                    worked.hits.push_back(hit ? std::optional(hit->primitive) : std::nullopt);
                }
                return worked;
            }};
}

inline std::vector<WorkTask> work_tasks() {
    Dice dice(11);
    std::vector<Ray> near, far;
    for (int i = 0; i < 200; ++i) {
        const Vec3d somewhere = dice.point(0.1, 15.9), way = dice.direction();
        near.push_back({convert<float>(somewhere), convert<float>(way)});
        far.push_back({convert<float>(somewhere - 1e6 * way), convert<float>(way)});
    }
    return {through_marbles("rays from nearby", near), through_marbles("rays from far away", far)};
}

}  // namespace raylab::grading::next_cell
