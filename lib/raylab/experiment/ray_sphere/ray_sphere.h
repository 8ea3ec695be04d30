#pragma once

#include "raylab/experiment/ray_sphere/quadratic.h"
#include "raylab/geometry/shapes.h"

#include <cmath>
#include <optional>

// Four ways to intersect a sphere, each a template on the number type it computes in. They differ in two places only:
// how they get the discriminant (does the ray hit?) and how they get the roots (where?). Equations: chapter 02.

namespace raylab {

/// |origin + t direction - center|^2 - radius^2 as a quadratic in t.
template <Real T>
Quadratic<T> along(const RayOf<T>& ray, const SphereOf<T>& sphere) {
    const Vec3<T> from_center = ray.origin - sphere.center;
    return {dot(ray.direction, ray.direction), dot(from_center, ray.direction),
            dot(from_center, from_center) - sphere.radius * sphere.radius};
}

/// The school formula: discriminant b^2 - a c, roots (-b +- sqrt(D)) / a.
template <Real T>
std::optional<T> textbook_sphere_hit(const RayOf<T>& ray, const SphereOf<T>& sphere) {
    const Quadratic<T> quadratic = along(ray, sphere);
    return first_inside(ray.range, textbook_roots(quadratic, quadratic.discriminant()));
}

/// The same discriminant, roots without cancellation: it cures the root, not the decision.
template <Real T>
std::optional<T> stable_sphere_hit(const RayOf<T>& ray, const SphereOf<T>& sphere) {
    const Quadratic<T> quadratic = along(ray, sphere);
    return first_inside(ray.range, stable_roots(quadratic, quadratic.discriminant()));
}

/// The vector from the sphere's center to the nearest point of the line.
template <Real T>
Vec3<T> offset_of_nearest_point(const RayOf<T>& ray, const SphereOf<T>& sphere, const Quadratic<T>& quadratic) {
    return (ray.origin - sphere.center) - ray.direction * (quadratic.half_b / quadratic.a);
}

/// The discriminant as a (r^2 - distance^2), the distance being the line's from the center: two numbers of the sphere's
/// size are subtracted, not two of the distance to the eye (Haines, Guenther and Akenine-Moeller, "Precision
/// Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019, chapter 7).
template <Real T>
std::optional<T> reformulated_sphere_hit(const RayOf<T>& ray, const SphereOf<T>& sphere) {
    const Quadratic<T> quadratic = along(ray, sphere);
    const Vec3<T> offset = offset_of_nearest_point(ray, sphere, quadratic);
    const T room = sphere.radius * sphere.radius - dot(offset, offset);
    if (!(room >= 0)) return std::nullopt;
    return first_inside(ray.range, stable_roots(quadratic, quadratic.a * room));
}

/// Differences of squares as products, in the discriminant (r + l)(r - l) (Pharr, Jakob and Humphreys, Physically Based
/// Rendering, 4th edition, section 6.8.3) and here in c = (|f| + r)(|f| - r) too.
template <Real T>
std::optional<T> factored_sphere_hit(const RayOf<T>& ray, const SphereOf<T>& sphere) {
    const T radius = sphere.radius;
    Quadratic<T> quadratic = along(ray, sphere);
    const Vec3<T> from_center = ray.origin - sphere.center;
    const T distance = std::sqrt(dot(from_center, from_center));
    quadratic.c = (distance + radius) * (distance - radius);
    const Vec3<T> offset = offset_of_nearest_point(ray, sphere, quadratic);
    const T nearest = std::sqrt(dot(offset, offset));
    const T room = (radius + nearest) * (radius - nearest);
    if (!(room >= 0)) return std::nullopt;
    return first_inside(ray.range, stable_roots(quadratic, quadratic.a * room));
}

}  // namespace raylab
