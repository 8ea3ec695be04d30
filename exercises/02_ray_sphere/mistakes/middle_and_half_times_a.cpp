// hint: precedence
// The middle of the chord and half of it, each divided by 2 and then multiplied by a.
#include "raylab/geometry/nearest_sphere_hit.h"

#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Vec3d f = ray.origin - sphere.center;
    const double a = dot(ray.direction, ray.direction);
    const double b = 2 * dot(ray.direction, f);
    const double c = dot(f, f) - std::pow(sphere.radius, 2);
    const double discriminant = std::pow(b, 2) - 4 * a * c;
    if (discriminant < 0) return std::nullopt;

    const double middle = -b / 2 * a;
    const double half_chord = std::sqrt(discriminant) / 2 * a;
    if (contains(ray.range, middle - half_chord)) return middle - half_chord;
    if (contains(ray.range, middle + half_chord)) return middle + half_chord;
    return std::nullopt;
}
