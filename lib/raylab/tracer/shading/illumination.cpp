#include "raylab/tracer/shading/illumination.h"

#include "raylab/geometry/scaled_to_largest_one.h"

#include <cmath>
#include <numbers>

namespace raylab {

namespace {

// Normalises a vector that may be as short or as long as a scene file can say.
Vec3d unit(const Vec3d& v) { return glm::normalize(scaled_to_largest_one(v)); }

// A spot's share of light in a unit direction away from it: nothing outside the cone, cos^exponent inside.
double share(const ShadingLight& spot, const Vec3d& away) {
    const double cosine = dot(away, spot.axis);
    if (cosine < spot.min_cosine) return 0;
    return spot.exponent == 0 ? 1 : std::pow(cosine, spot.exponent);
}

}  // namespace

ShadingLight::ShadingLight(const Light& light)
    : kind(static_cast<Kind>(light.kind.index())),
      color(light.color),
      attenuation(light.attenuation),
      dims(kind == Kind::spot || attenuation != Vec3d{1, 0, 0}) {
    if (const auto* point = std::get_if<PointLight>(&light.kind)) position = point->position;
    if (const auto* sun = std::get_if<DistantLight>(&light.kind)) axis = unit(sun->direction);
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) {
        position = spot->position;
        axis = unit(spot->target - spot->position);
        min_cosine = std::cos(spot->cone * std::numbers::pi / 180);
        exponent = spot->exponent;
    }
}

// It falls off as 1 / (constant + linear d + quadratic d^2).
std::optional<Color> dimmed(const ShadingLight& light, const Bearing& toward) {
    const Vec3d& by = light.attenuation;
    const double part = 1 / (by.x + toward.distance * (by.y + toward.distance * by.z));
    if (!std::isfinite(part)) return std::nullopt;  // so near that the quadratic term has vanished
    const Color arriving = light.color * part;
    if (light.kind != ShadingLight::Kind::spot) return arriving;
    const double in_cone = share(light, -toward.to_light);
    if (in_cone == 0) return std::nullopt;
    return arriving * in_cone;
}

}  // namespace raylab
