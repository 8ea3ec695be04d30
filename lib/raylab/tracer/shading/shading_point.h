#pragma once

#include "raylab/tracer/shading/lighting.h"
#include "raylab/tracer/shading/reflected_light.h"
#include "raylab/tracer/shading/surface_point.h"
#include "raylab/tracer/whitted/whitted.h"

#include <array>
#include <limits>
#include <optional>

// The point where a ray of the recursion hits a surface, and the rays that leave it.

namespace raylab {

/// The point that a ray hit, seen from the side it came from. It refers to the ray and the point.
struct ShadingPoint {
    const Ray& ray;
    double t;
    const SurfacePoint& at;
    Vec3d direction;        // of the ray, unit
    Vec3d normal, shading;  // unit, on the ray's side
    bool front;             // whether that is the outer side
    const Finish& material;
    Vec3f beside = {};  // where rays begin that leave on this side, if the tracer has a use for it
};

inline ShadingPoint shading_point(const Lighting& lighting, const Ray& ray, double t, const SurfacePoint& at) {
    Vec3d direction = glm::normalize(convert<double>(ray.direction));
    const bool front = !(dot(at.normal, direction) > 0);
    return {ray,
            t,
            at,
            direction,
            front ? at.normal : -at.normal,
            front ? at.shading_normal : -at.shading_normal,
            front,
            lighting.finishes[front ? at.object->front : at.object->back]};
}

/// The same point as if it were seen from the outer side.
inline ShadingPoint from_outside(const ShadingPoint& here) {
    const SurfacePoint& at = here.at;
    return {here.ray,       here.t,        at,
            here.direction, at.normal,     at.shading_normal,
            true,           here.material, start_beside(at, at.normal)};
}

/// The unit direction in which highlights are looked at.
inline Vec3d to_viewer(const ShadingPoint& here, const WhittedOptions& options) {
    return options.viewer == WhittedOptions::Viewer::at_infinity ? options.to_viewer : -here.direction;
}

/// The direction to the viewer from another point of the surface that the ray hit.
Vec3d to_viewer(const ShadingPoint& here, const Vec3d& position, const Camera& camera, const WhittedOptions& options);

/// The corners of the smooth triangle that the point lies in, as light reaches them on the side it is seen from.
std::array<LitPoint, 3> lit_corners(const ShadingPoint& here, const Camera& camera, const WhittedOptions& options);

/// The ray that leaves a point in a unit direction on the side it is seen from. Inlined here and in mirrored(): 1 % of
/// the picture of tests/bench/mirror_and_glass.toml.
[[gnu::always_inline]] inline Ray leaving_here(const ShadingPoint& here, const Vec3d& direction, double length,
                                               const RayStart& start) {
    if (start.offset == RayStart::Offset::error_bounded)
        return ray_begun_at(here.beside, here.at, direction, length, start.leaving);
    return ray_with_other_start(here.at, direction, length, start, here.ray, here.t);
}

/// The ray that leaves a point in any unit direction, without end.
inline Ray leaving(const ShadingPoint& here, const Vec3d& direction, const RayStart& start) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const double away = dot(here.normal, direction);
    if (away > 0 || start.offset != RayStart::Offset::error_bounded)
        return leaving_here(here, direction, endless, start);
    const Vec3d normal = away < 0 ? -here.normal : here.at.normal;
    return ray_begun_at(start_beside(here.at, normal), here.at, direction, endless, start.leaving);
}

/// The mirrored ray, d - 2 (d.n) n: by the smooth normal, or by the surface's own where that one would send it into the
/// surface.
[[gnu::always_inline]] inline Ray mirrored(const ShadingPoint& here, const RayStart& start) {
    const auto by = [&](const Vec3d& n) { return here.direction - 2 * dot(here.direction, n) * n; };
    const Vec3d smooth = by(here.shading);
    if (dot(smooth, here.normal) > 0) return leaving_here(here, smooth, std::numeric_limits<double>::infinity(), start);
    return leaving(here, by(here.normal), start);
}

/// Continues through a hidden surface, whatever the options say of starting: it does not add to the depth, so it must
/// never hit this surface again.
inline Ray onward(const ShadingPoint& here) {
    return ray_from(here.at, here.direction, std::numeric_limits<double>::infinity(), RayStart{}, here.ray, here.t);
}

/// The shares of the light from two directions, and the refracted one.
struct Branches {
    double reflected = 0, transmitted = 0;  // shares
    std::optional<Vec3d> refracted = {};    // absent: total internal reflection
};

/// The branches at a transparent surface between matter of these indices of refraction.
Branches branches_at(const ShadingPoint& here, double ior_before, double ior_behind,
                     WhittedOptions::Reflectance reflectance);

}  // namespace raylab
