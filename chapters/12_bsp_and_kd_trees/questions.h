#pragma once

#include "raylab/accelerator/split_tree/plane_rule.h"
#include "raylab/experiment/structure/structure_question.h"
#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::split {

/// The exact trees of planes, by rule; the kd-trees with mistakes are weak_trees().
std::vector<StructureMethod> strong_trees(const SahCosts& costs = {});
std::vector<StructureMethod> weak_trees();

/// A thousand long thin triangles in all directions: each lies in many cells.
StructureWorkload straw(std::size_t rays, std::uint64_t seed);

/// Two hundred spheres, few of them large: each box contains much empty space.
StructureWorkload balls(std::size_t rays, std::uint64_t seed);

/// Rays that start in the planes which divide a tree's cells; most of them stay in one plane, and some in two.
StructureWorkload in_planes(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                            std::uint64_t seed);

/// Squares of two triangles each, a floor and a wall: all lie in planes.
std::shared_ptr<const Scene> tiles();

/// A sphere with bumps.
std::shared_ptr<const Scene> bumps(const ChapterRun& run);

/// The nearest hit by trees of planes.
Experiment measure_trees(const ChapterRun& run);

}  // namespace raylab::split
