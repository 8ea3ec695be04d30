#include "raylab/tracer/place.h"

#include "raylab/tracer/fresnel.h"
#include "raylab/tracer/refracted_direction.h"

namespace raylab {

// An orthographic eye is nowhere: all its rays are parallel.
Vec3d to_viewer(const Place& place, const Vec3d& position, const Camera& camera, const WhittedOptions& options) {
    const bool local = options.viewer == WhittedOptions::Viewer::local;
    if (!local || std::holds_alternative<Orthographic>(camera.projection)) return to_viewer(place, options);
    return glm::normalize(convert<double>(place.ray.origin) - position);
}

std::array<LitPoint, 3> lit_corners(const Place& place, const Camera& camera, const WhittedOptions& options) {
    const auto lit = [&](const Corner& corner) -> LitPoint {
        return {corner.position, place.front ? corner.normal : -corner.normal,
                to_viewer(place, corner.position, camera, options)};
    };
    const auto [a, b, c] = corners(place.at);
    return {lit(a), lit(b), lit(c)};
}

// What a ray is bent about: the smooth normal, or the surface's own where the smooth one looks away or would keep the ray
// on this side.
Branches branches_at(const Place& place, double ior_before, double ior_behind, WhittedOptions::Reflectance reflectance) {
    const double kr = place.material.kr, kt = place.material.kt;
    const auto bent = [&](const Vec3d& n) { return refracted_direction(place.direction, n, ior_before, ior_behind); };
    const bool faces = dot(place.direction, place.shading) < 0;
    const Vec3d* normal = faces ? &place.shading : &place.normal;
    Branches branches{kr, kt, bent(*normal)};
    if (faces && branches.refracted && !(dot(*branches.refracted, place.normal) < 0)) {
        normal = &place.normal;
        branches.refracted = bent(*normal);
    }
    if (!branches.refracted) {
        branches.reflected = kr + kt;
        branches.transmitted = 0;
    } else if (reflectance == WhittedOptions::Reflectance::fresnel) {
        const double share = fresnel(-dot(place.direction, *normal), ior_before, ior_behind);
        branches.reflected = (kr + kt) * share;
        branches.transmitted = (kr + kt) * (1 - share);
    }
    return branches;
}

}  // namespace raylab
