#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    // The foot of the perpendicular from the center to the line, and half the chord to either side of it.
    const Vec3d to_center = sphere.center - ray.origin;
    const double speed = std::sqrt(dot(ray.direction, ray.direction));
    const Vec3d unit = ray.direction / speed;
    const double foot = dot(to_center, unit);
    const Vec3d off = to_center - unit * foot;
    const double half_chord_squared = sphere.radius * sphere.radius - dot(off, off);
    if (half_chord_squared < 0) return std::nullopt;
    const double half_chord = std::sqrt(half_chord_squared);
    const double enter = (foot - half_chord) / speed;
    const double leave = (foot + half_chord) / speed;
    if (enter >= ray.range.min && enter <= ray.range.max) return enter;
    if (leave >= ray.range.min && leave <= ray.range.max) return leave;
    return std::nullopt;
}
