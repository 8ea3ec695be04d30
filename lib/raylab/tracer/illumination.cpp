#include "raylab/tracer/illumination.h"

#include "raylab/geometry/of_size_one.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace raylab {

namespace {

// Of a vector that may be as short or as long as a scene file can say.
Vec3d unit(const Vec3d& v) { return glm::normalize(of_size_one(v)); }

// A spot's share of light in a unit direction away from it: nothing outside the cone, cos^exponent inside.
double share(const SpotLight& spot, const Vec3d& away) {
    const double cosine = dot(away, unit(spot.target - spot.position));
    if (cosine < std::cos(spot.cone * std::numbers::pi / 180)) return 0;
    return spot.exponent == 0 ? 1 : std::pow(cosine, spot.exponent);
}

}  // namespace

std::optional<Illumination> detail::illumination_of_spot_or_sun(const Light& light, const Vec3d& point) {
    if (const auto* sun = std::get_if<DistantLight>(&light.kind))
        return Illumination{-unit(sun->direction), std::numeric_limits<double>::infinity(), light.color};
    const auto& spot = std::get<SpotLight>(light.kind);
    auto found = illumination_from(spot.position, light, point);
    if (!found) return found;
    const double part = share(spot, -found->to_light);
    if (part == 0) return std::nullopt;
    found->color *= part;
    return found;
}

}  // namespace raylab
