#pragma once

#include "raylab/tracer/lighting.h"
#include "raylab/tracer/reflected_light.h"
#include "raylab/tracer/surface_point.h"
#include "raylab/tracer/whitted.h"

#include <array>
#include <limits>
#include <optional>

// Where a ray of the recursion stands, and which ways lead on from there.

namespace raylab {

/// What a ray met, seen from the side it came from. It refers to the ray and the point.
struct Place {
    const Ray& ray;
    double t;
    const SurfacePoint& at;
    Vec3d direction;        // of the ray, unit
    Vec3d normal, shading;  // unit, on the ray's side
    bool front;             // whether that is the outer side
    const Finish& material;
    Vec3f beside = {};  // where rays begin that leave on this side, if the tracer has a use for it
};

inline Place place(const Lighting& lighting, const Ray& ray, double t, const SurfacePoint& at) {
    Vec3d direction = glm::normalize(convert<double>(ray.direction));
    const bool front = !(dot(at.normal, direction) > 0);
    return {ray, t, at, direction, front ? at.normal : -at.normal, front ? at.shading_normal : -at.shading_normal, front,
            lighting.finishes[front ? at.object->front : at.object->back]};
}

/// The same place as if it were seen from the outer side.
inline Place from_outside(const Place& place) {
    const SurfacePoint& at = place.at;
    return {place.ray, place.t, at, place.direction, at.normal, at.shading_normal, true, place.material,
            detail::beside(at, at.normal)};
}

/// The unit direction in which highlights are looked at.
inline Vec3d to_viewer(const Place& place, const WhittedOptions& options) {
    return options.viewer == WhittedOptions::Viewer::at_infinity ? options.to_viewer : -place.direction;
}

/// The same at another point of the surface that the ray met.
Vec3d to_viewer(const Place& place, const Vec3d& position, const Camera& camera, const WhittedOptions& options);

/// The corners of the smooth triangle that the point lies in, as light meets them on the side it is seen from.
std::array<LitPoint, 3> lit_corners(const Place& place, const Camera& camera, const WhittedOptions& options);

/// A ray that leaves the place in a unit direction on the side it is seen from.
[[gnu::always_inline]] inline Ray leaving_here(const Place& place, const Vec3d& direction, double length, const RayStart& start) {
    if (start.offset == RayStart::Offset::error_bounded)
        return detail::ray_begun(place.beside, place.at, direction, length, start.leaving);
    return detail::ray_started_otherwise(place.at, direction, length, start, place.ray, place.t);
}

/// A ray that leaves it in any unit direction, without end.
inline Ray leaving(const Place& place, const Vec3d& direction, const RayStart& start) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const double away = dot(place.normal, direction);
    if (away > 0 || start.offset != RayStart::Offset::error_bounded) return leaving_here(place, direction, endless, start);
    const Vec3d normal = away < 0 ? -place.normal : place.at.normal;
    return detail::ray_begun(detail::beside(place.at, normal), place.at, direction, endless, start.leaving);
}

/// The mirrored ray, d - 2 (d.n) n: by the smooth normal, or by the surface's own where that one would send it into the
/// surface.
[[gnu::always_inline]] inline Ray mirrored(const Place& place, const RayStart& start) {
    const auto by = [&](const Vec3d& n) { return place.direction - 2 * dot(place.direction, n) * n; };
    const Vec3d smooth = by(place.shading);
    if (dot(smooth, place.normal) > 0) return leaving_here(place, smooth, std::numeric_limits<double>::infinity(), start);
    return leaving(place, by(place.normal), start);
}

/// Straight on, whatever is said of leaving: it does not count for the depth, so it must get away from here.
inline Ray onward(const Place& place) {
    return ray_from(place.at, place.direction, std::numeric_limits<double>::infinity(), RayStart{}, place.ray, place.t);
}

/// How the light of two directions is mixed in.
struct Branches {
    double reflected = 0, transmitted = 0;  // shares
    std::optional<Vec3d> refracted = {};    // absent: total reflection
};

/// The branches at a transparent place between matter of these indices of refraction.
Branches branches_at(const Place& place, double ior_before, double ior_behind, WhittedOptions::Reflectance reflectance);

}  // namespace raylab
