#pragma once

#include "raylab/accelerator/split_tree/plane_rule.h"
#include "raylab/report/chapter.h"
#include "raylab/report/structure/structure_question.h"

#include <vector>

namespace raylab::split {

/// The trees of planes that hold, by rule; then the kd-tree with each mistake.
std::vector<StructureMethod> strong_trees(const SahCosts& costs = {});
std::vector<StructureMethod> weak_trees();

/// A thousand long thin triangles in all directions: each lies in many cells.
StructureWorkload straw(std::size_t rays, std::uint64_t seed);

/// Two hundred balls, few of them large: each box holds much that is not its ball.
StructureWorkload balls(std::size_t rays, std::uint64_t seed);

/// Rays that start in the planes which cut a tree's cells, mostly stay in one of them, and now and then in two.
StructureWorkload in_planes(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                            std::uint64_t seed);

/// Squares of two triangles each, a floor and a wall: all lie in planes.
std::shared_ptr<const Scene> tiles();

/// A ball with bumps.
std::shared_ptr<const Scene> bumps(const ChapterRun& run);

/// What is the nearest hit? Asked of trees of planes.
Experiment measure_trees(const ChapterRun& run);

}  // namespace raylab::split
