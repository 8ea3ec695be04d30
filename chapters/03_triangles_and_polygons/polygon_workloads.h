#pragma once

#include "raylab/experiment/ray_polygon/methods.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// Rays and polygons, in floats.
using PolygonWorkload = Workload<Polygon, PolygonQuery>;

/// Convex and concave polygons of 4 to 12 vertices, each with rays at random places and at its edges: four sets of
/// `count` queries.
std::vector<PolygonWorkload> polygon_workloads(std::size_t count, std::uint64_t seed);

}  // namespace raylab
