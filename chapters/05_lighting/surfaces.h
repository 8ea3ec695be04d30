#pragma once

#include "raylab/geometry/vector.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// Surfaces whose normals can be computed in more than one way.

namespace raylab::lighting {

/// A surface in two representations: as P(u, v), and as the zeros of a function F.
struct TwoWaySurface {
    std::string name;
    std::function<Vec3d(double u, double v)> point;
    std::function<Vec3d(double u, double v)> by_gradient;  // of length 1
    std::function<Vec3d(double u, double v)> by_tangents;  // of length 1: dP/du x dP/dv
};

/// An ellipsoid, a torus, a cylinder; u and v from 0 to 1.
std::vector<TwoWaySurface> two_way_surfaces();

/// The normal by three points of the surface that are `step` apart in u and v: (B - A) x (C - A).
Vec3d by_three_points(const TwoWaySurface& surface, double u, double v, double step);

/// The worst angle between a way's normal and the gradient, at 1000 points, in radians.
using NormalWay = std::function<Vec3d(double u, double v)>;
double worst_lean(const TwoWaySurface& surface, const NormalWay& way, std::uint64_t seed);
double worst_lean_by_three_points(const TwoWaySurface& surface, double step, std::uint64_t seed);

}  // namespace raylab::lighting
