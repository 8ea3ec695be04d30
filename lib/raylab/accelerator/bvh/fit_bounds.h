#pragma once

#include "raylab/accelerator/bvh/box_tree.h"
#include "raylab/accelerator/primitives.h"
#include "raylab/geometry/bounds/bounding_sphere.h"
#include "raylab/geometry/bounds/slabs.h"

#include <array>
#include <vector>

namespace raylab {

/// For each node of a tree the bounds of its two children. Each bound is computed from all the primitives below it, not
/// from the bounds of its children, because bounds of bounds would enclose more empty space at every level. `ordered`
/// holds the primitives in the tree's order.
template <class One>
std::vector<std::array<One, 2>> fit_bounds(const BoxTree& tree, const Primitives& ordered);

/// The bound of all primitives.
template <class One>
One fit_bound(const Primitives& primitives);

extern template std::vector<std::array<Sphere, 2>> fit_bounds(const BoxTree&, const Primitives&);
extern template std::vector<std::array<Slabs, 2>> fit_bounds(const BoxTree&, const Primitives&);
template <>
Box fit_bound(const Primitives& primitives);
extern template Sphere fit_bound(const Primitives&);
extern template Slabs fit_bound(const Primitives&);

}  // namespace raylab
