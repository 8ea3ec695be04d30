#pragma once

#include "raylab/experiment/structure/structure_method.h"
#include "raylab/report/chapter.h"

namespace raylab::octrees {

/// The algorithms for the next cell: the textbooks', or `yours` instead of them where a student's function runs, then
/// the lab's three.
std::vector<StructureMethod> ways(const ChapterRun& run);
std::vector<StructureMethod> exact_ways();
StructureMethod way(const std::string& name, const ChapterRun& run);

/// Measures speed against wrong answers.
Experiment measure_octrees(const ChapterRun& run);

/// When is a cell a leaf? The cost for the limits of few, deep and shared.
std::vector<std::string> leaf_header();
std::vector<std::vector<std::string>> leaf_rows(const ChapterRun& run);

/// One octree, and SEADS of several sizes in its leaves.
std::vector<std::string> way_header();
std::vector<std::vector<std::string>> way_rows(const ChapterRun& run);

}  // namespace raylab::octrees
