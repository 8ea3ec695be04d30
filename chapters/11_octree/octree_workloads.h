#pragma once

#include "raylab/experiment/structure/structure_workload.h"

namespace raylab::octrees {

/// A knot of a thin tube in the corner of a hall: large triangles and small ones.
std::shared_ptr<const Scene> hall(int levels);

/// Rays at grains of dust in a cube of side 2, from this distance.
StructureWorkload dust_rays(double distance, std::size_t rays, std::uint64_t seed);
inline constexpr double far_away = 4000;

/// Rays along edges and through corners of cells of an octree whose planes are floats, at triangles that lie in these
/// planes.
StructureWorkload plane_rays(std::size_t rays, std::uint64_t seed);

}  // namespace raylab::octrees
