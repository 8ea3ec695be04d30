#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"
#include "raylab/sampling/mapping/sphere_cone.h"

#include <algorithm>
#include <cmath>

// A direction in the cone of the sphere, and the nearer of the two points in which it meets the sphere.
raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from;
    const double distance = glm::length(way);
    const SphereCone cone = SphereCone::around(radius, distance);
    const Vec3d local = cone.direction(u, v);
    const double sine_squared = local.x * local.x + local.y * local.y;
    const double half_chord = std::sqrt(std::max(0.0, radius * radius - distance * distance * sine_squared));
    const Vec3d direction = frame_around(way / distance).to_world(local);
    return {from + (distance * local.z - half_chord) * direction, cone.pdf()};
}
