#pragma once

#include "raylab/report/chapter.h"
#include "raylab/report/structure_method.h"
#include "raylab/report/structure_workload.h"

namespace raylab::octrees {

/// The ways to the next cell that are tried: textbooks' first, `yours` in their place where a student's function runs, then the
/// lab's three.
std::vector<StructureMethod> ways(const ChapterRun& run);
std::vector<StructureMethod> exact_ways();
StructureMethod way(const std::string& name, const ChapterRun& run);

/// A knot of thin tube in the corner of a hall: large triangles and small ones.
std::shared_ptr<const Scene> hall(int levels);

/// At grains of dust in a cube 2 wide, from such a distance.
StructureWorkload dust_rays(double distance, std::size_t rays, std::uint64_t seed);
inline constexpr double far_away = 4000;

/// Along edges and through corners of cells of an octree over markers whose planes are floats, at triangles that lie in them.
StructureWorkload plane_rays(std::size_t rays, std::uint64_t seed);

/// Speed against wrong answers.
Experiment measure_octrees(const ChapterRun& run);

/// When a cell is a leaf: what few, deep and shared cost.
std::vector<std::string> leaf_header();
std::vector<std::vector<std::string>> leaf_rows(const ChapterRun& run);

/// One octree, and SEADS of several sizes in its leaves.
std::vector<std::string> way_header();
std::vector<std::vector<std::string>> way_rows(const ChapterRun& run);

}  // namespace raylab::octrees
