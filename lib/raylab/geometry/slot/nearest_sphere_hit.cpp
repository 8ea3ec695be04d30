#include "raylab/geometry/nearest_sphere_hit.h"

#include <algorithm>
#include <cmath>

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    // |f + t d|^2 = r^2, with f from the center to the origin, is a t^2 + 2 b t + c = 0.
    const Vec3d f = ray.origin - sphere.center;
    const Vec3d d = ray.direction;
    const double a = dot(d, d);
    const double b = dot(f, d);
    const double c = dot(f, f) - sphere.radius * sphere.radius;

    const double discriminant = b * b - a * c;
    if (discriminant < 0) return std::nullopt;  // the line passes by; zero is a tangent, and a tangent hits

    // b and the root have one sign here, so nothing cancels; the other crossing follows from t0 t1 = c / a.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    const double one = q / a;
    const double other = q != 0 ? c / q : one;

    for (const double t : {std::min(one, other), std::max(one, other)})
        if (t >= ray.range.min && t <= ray.range.max) return t;  // the way out, where the origin lies inside
    return std::nullopt;
}
