#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// A point of a light, chosen at random.
struct LightPoint {
    Vec3d point;
    double pdf;  // how likely the directions near it are, as seen from the lit point, per steradian
};

/// The point of a spherical light that two uniform numbers in [0, 1) stand for, chosen among those that are seen from
/// `from`, which lies outside: uniform over the solid angle of the sphere. This is the slot of exercise 15c.
LightPoint light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v);

}  // namespace raylab
