#include "raylab/tracer/shading/shading_point.h"

#include "raylab/tracer/refracted_direction.h"
#include "raylab/tracer/shading/fresnel.h"

namespace raylab {

// An orthographic eye is nowhere: all its rays are parallel.
Vec3d to_viewer(const ShadingPoint& here, const Vec3d& position, const Camera& camera, const WhittedOptions& options) {
    const bool local = options.viewer == WhittedOptions::Viewer::local;
    if (!local || std::holds_alternative<Orthographic>(camera.projection)) return to_viewer(here, options);
    return glm::normalize(convert<double>(here.ray.origin) - position);
}

std::array<LitPoint, 3> lit_corners(const ShadingPoint& here, const Camera& camera, const WhittedOptions& options) {
    const auto lit = [&](const Corner& corner) -> LitPoint {
        return {corner.position, here.front ? corner.normal : -corner.normal,
                to_viewer(here, corner.position, camera, options)};
    };
    const auto [a, b, c] = corners(here.at);
    return {lit(a), lit(b), lit(c)};
}

// A ray is refracted about the smooth normal, or about the surface's own where the smooth one looks away or would keep
// the ray on this side.
Branches branches_at(const ShadingPoint& here, double ior_before, double ior_behind,
                     WhittedOptions::Reflectance reflectance) {
    const double kr = here.material.kr, kt = here.material.kt;
    const auto bent = [&](const Vec3d& n) { return refracted_direction(here.direction, n, ior_before, ior_behind); };
    const bool faces = dot(here.direction, here.shading) < 0;
    const Vec3d* normal = faces ? &here.shading : &here.normal;
    Branches branches{kr, kt, bent(*normal)};
    if (faces && branches.refracted && !(dot(*branches.refracted, here.normal) < 0)) {
        normal = &here.normal;
        branches.refracted = bent(*normal);
    }
    if (!branches.refracted) {
        branches.reflected = kr + kt;
        branches.transmitted = 0;
    } else if (reflectance == WhittedOptions::Reflectance::fresnel) {
        const double share = fresnel(-dot(here.direction, *normal), ior_before, ior_behind);
        branches.reflected = (kr + kt) * share;
        branches.transmitted = (kr + kt) * (1 - share);
    }
    return branches;
}

}  // namespace raylab
