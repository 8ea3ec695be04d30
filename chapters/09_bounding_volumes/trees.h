#pragma once

#include "other_trees.h"

#include "raylab/experiment/structure/structure_workload.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter.h"

#include <memory>
#include <string>
#include <vector>

namespace raylab::volumes {

/// The lab's hierarchies: spheres, boxes, oriented boxes, and the wide one.
std::vector<StructureMethod> trees();

/// A tube in the shape of a trefoil knot: long, bent, and nowhere parallel to an axis.
std::shared_ptr<const Scene> knot(int levels);

/// A square of towers, each a metre wide and some metres high, with rays vertically down on it, this many along each
/// side: every sixteenth (of 256) is in the plane of walls.
StructureWorkload city_rays(int along_side);

/// Rays to the corners of a mesh's triangles, from all around.
StructureWorkload corner_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                              std::uint64_t seed);

/// A picture of the city by a tree: red where its answer is wrong.
Image city_through(const StructureMethod& method, int along_side);

Experiment measure_hierarchies(const ChapterRun& run);

/// The cost for each tree of the rays of the knot's picture, and of the rays that go on from there.
std::vector<std::string> counts_header();
std::vector<std::vector<std::string>> counts_rows(const std::vector<StructureMethod>& methods, const ChapterRun& run);

/// The cost of a ray where leaves have 1, 4, 16, 64 triangles, for the knot and for the city.
std::vector<std::string> depth_header();
std::vector<std::vector<std::string>> depth_rows(const ChapterRun& run);

}  // namespace raylab::volumes
