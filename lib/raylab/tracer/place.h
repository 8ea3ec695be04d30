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

/// The mirrored direction d - 2 (d.n) n: by the smooth normal, or by the surface's own where that one would send the ray
/// into the surface.
inline Vec3d mirrored(const Place& place) {
    const auto by = [&](const Vec3d& n) { return place.direction - 2 * dot(place.direction, n) * n; };
    const Vec3d smooth = by(place.shading);
    return dot(smooth, place.normal) > 0 ? smooth : by(place.normal);
}

/// The unit direction in which highlights are looked at.
inline Vec3d to_viewer(const Place& place, const WhittedOptions& options) {
    return options.viewer == WhittedOptions::Viewer::at_infinity ? options.to_viewer : -place.direction;
}

/// The same at another point of the surface that the ray met.
Vec3d to_viewer(const Place& place, const Vec3d& position, const Camera& camera, const WhittedOptions& options);

enum class Side { outer, inner };

/// The corners of the smooth triangle that the point lies in, as light meets them on that side.
std::array<LitPoint, 3> lit_corners(const Place& place, Side side, const Camera& camera, const WhittedOptions& options);

/// A ray that leaves the place in a unit direction.
[[gnu::always_inline]] inline Ray leaving(const Place& place, const Vec3d& direction, double length, const RayStart& start) {
    if (start.offset == RayStart::Offset::error_bounded && dot(place.normal, direction) > 0)
        return detail::ray_begun(place.beside, place.at, direction, length, start.leaving);
    return ray_from(place.at, direction, length, start, place.ray, place.t);
}

/// Straight on, whatever is said of leaving: it does not count for the depth, so it must get away from here.
inline Ray onward(const Place& place) {
    return ray_from(place.at, place.direction, std::numeric_limits<double>::infinity(), RayStart{}, place.ray, place.t);
}

/// How the light of two directions is mixed in.
struct Branches {
    double reflected = 0, transmitted = 0;  // shares
    std::optional<Vec3d> refracted = {};    // absent: total reflection, or an opaque surface
};

/// The branches at a place between matter of these indices of refraction.
Branches branches_at(const Place& place, double ior_before, double ior_behind, WhittedOptions::Reflectance reflectance);

}  // namespace raylab
