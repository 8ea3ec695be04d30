#pragma once

#include "raylab/geometry/vector.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// Surfaces whose normals are known in more than one way.

namespace raylab::lighting {

/// A surface in two ways: P(u, v), and where F is zero.
struct TwoWaySurface {
    std::string name, implicit, parametric;
    std::function<Vec3d(double u, double v)> point;
    std::function<Vec3d(double u, double v)> by_gradient;  // unit
    std::function<Vec3d(double u, double v)> by_tangents;  // unit: dP/du x dP/dv
};

/// An ellipsoid, a torus, a cylinder; u and v from 0 to 1.
std::vector<TwoWaySurface> two_way_surfaces();

/// By three points of the surface, `step` of u and v apart: (B - A) x (C - A).
Vec3d by_three_points(const TwoWaySurface& surface, double u, double v, double step);

/// How far a way leans off the gradient: the worst angle at 1000 points, in radians.
using NormalWay = std::function<Vec3d(double u, double v)>;
double worst_lean(const TwoWaySurface& surface, const NormalWay& way, std::uint64_t seed);
double worst_lean_by_three_points(const TwoWaySurface& surface, double step, std::uint64_t seed);

}  // namespace raylab::lighting
