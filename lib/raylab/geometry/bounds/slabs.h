#pragma once

#include "raylab/geometry/bounds/hull.h"

#include <array>

namespace raylab {

/// A box in any direction as its three slabs hold it (Kay and Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986):
/// exactly the points p with |axes[i] . (p - center)| <= half[i]. The axes are unit and perpendicular but for their
/// rounding, which the halves make good.
struct Slabs {
    Vec3f center{0};
    std::array<Vec3f, 3> axes{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};
    Vec3f half{0};
};

/// Slabs around balls, their halves rounded up; nearly the smallest (Larsson and Kallberg, Fast Computation of
/// Tight-Fitting Oriented Bounding Boxes, Game Engine Gems 2, 2011: the axes are an edge and the normal of a large
/// triangle in the hull, of several the best). A half is infinite where something reaches to infinity, minus infinity
/// around nothing.
Slabs bounding_slabs(std::span<const Ball> balls);

}  // namespace raylab
