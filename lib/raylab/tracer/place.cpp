#include "raylab/tracer/place.h"

#include "raylab/tracer/fresnel.h"
#include "raylab/tracer/refracted_direction.h"

namespace raylab {

namespace {

// What a ray is bent about: the smooth normal, or the surface's own where the smooth one looks away or would keep the ray
// on this side.
struct Bent {
    Vec3d normal;
    std::optional<Vec3d> direction;  // absent: total reflection
};

Bent bent(const Place& place, double before, double behind) {
    const auto by = [&](const Vec3d& n) { return Bent{n, refracted_direction(place.direction, n, before, behind)}; };
    if (!(dot(place.direction, place.shading) < 0)) return by(place.normal);
    const Bent smooth = by(place.shading);
    return smooth.direction && !(dot(*smooth.direction, place.normal) < 0) ? by(place.normal) : smooth;
}

}  // namespace

// An orthographic eye is nowhere: all its rays are parallel.
Vec3d to_viewer(const Place& place, const Vec3d& position, const Camera& camera, const WhittedOptions& options) {
    const bool local = options.viewer == WhittedOptions::Viewer::local;
    if (!local || std::holds_alternative<Orthographic>(camera.projection)) return to_viewer(place, options);
    return glm::normalize(convert<double>(place.ray.origin) - position);
}

std::array<LitPoint, 3> lit_corners(const Place& place, Side side, const Camera& camera, const WhittedOptions& options) {
    const auto lit = [&](const Corner& corner) -> LitPoint {
        return {corner.position, side == Side::inner ? -corner.normal : corner.normal,
                to_viewer(place, corner.position, camera, options)};
    };
    const auto [a, b, c] = corners(place.at);
    return {lit(a), lit(b), lit(c)};
}

Branches branches_at(const Place& place, double ior_before, double ior_behind, WhittedOptions::Reflectance reflectance) {
    const double kr = place.material.kr, kt = place.material.kt;
    if (kt == 0) return {kr};
    const auto [normal, refracted] = bent(place, ior_before, ior_behind);
    if (!refracted) return {kr + kt};
    if (reflectance == WhittedOptions::Reflectance::constant) return {kr, kt, refracted};
    const double share = fresnel(-dot(place.direction, normal), ior_before, ior_behind);
    return {(kr + kt) * share, (kr + kt) * (1 - share), refracted};
}

}  // namespace raylab
