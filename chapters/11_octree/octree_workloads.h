#pragma once

#include "raylab/report/structure/structure_workload.h"

namespace raylab::octrees {

/// A knot of thin tube in the corner of a hall: large triangles and small ones.
std::shared_ptr<const Scene> hall(int levels);

/// At grains of dust in a cube 2 wide, from such a distance.
StructureWorkload dust_rays(double distance, std::size_t rays, std::uint64_t seed);
inline constexpr double far_away = 4000;

/// Along edges and through corners of cells of an octree over markers whose planes are floats, at triangles that lie in
/// them.
StructureWorkload plane_rays(std::size_t rays, std::uint64_t seed);

}  // namespace raylab::octrees
