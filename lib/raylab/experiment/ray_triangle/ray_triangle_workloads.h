#pragma once

#include "raylab/experiment/ray_triangle/methods.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace raylab {

/// Pairs of a ray and a triangle, query i for triangle i, all in floats. Except for the first, each set makes one thing
/// hard; random pairs alone cannot tell one method from another.
using TriangleWorkload = Workload<Triangle, TriangleQuery>;

/// generic, edge, vertex, sliver, grazing, off1e4, far1e6, tiny1e-15, huge1e13, lattice.
std::vector<std::string> ray_triangle_workload_names();

/// `count` pairs of the set with this name, which must be known (an assertion). The same seed gives the same pairs, and
/// a longer set begins with the shorter one.
TriangleWorkload ray_triangle_workload(const std::string& name, std::size_t count, std::uint64_t seed);

}  // namespace raylab
