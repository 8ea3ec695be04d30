#include "raylab/tracer/illumination.h"

#include "raylab/geometry/of_size_one.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace raylab {

namespace {

// 1 / (constant + linear d + quadratic d^2).
double falloff(const Vec3d& attenuation, double distance) {
    return 1 / (attenuation.x + distance * (attenuation.y + distance * attenuation.z));
}

// Of a vector that may be as short or as long as a scene file can say.
Vec3d unit(const Vec3d& v) { return glm::normalize(of_size_one(v)); }

// A spot's share of light in a unit direction away from it: nothing outside the cone, cos^exponent inside.
double share(const SpotLight& spot, const Vec3d& away) {
    const double cosine = dot(away, unit(spot.target - spot.position));
    if (cosine < std::cos(spot.cone * std::numbers::pi / 180)) return 0;
    return spot.exponent == 0 ? 1 : std::pow(cosine, spot.exponent);
}

struct SeenFrom {
    const Light& light;
    const Vec3d& point;

    std::optional<Illumination> from(const Vec3d& position) const {
        const Vec3d way = position - point;
        const double distance = glm::length(way);
        if (!(distance > 0)) return std::nullopt;
        const double part = falloff(light.attenuation, distance);
        if (!std::isfinite(part)) return std::nullopt;  // so near that the quadratic term has vanished
        return Illumination{way / distance, distance, light.color * part};
    }

    std::optional<Illumination> operator()(const PointLight& at) const { return from(at.position); }
    std::optional<Illumination> operator()(const SpotLight& spot) const {
        auto found = from(spot.position);
        if (!found) return found;
        const double part = share(spot, -found->to_light);
        if (part == 0) return std::nullopt;
        found->color *= part;
        return found;
    }
    std::optional<Illumination> operator()(const DistantLight& sun) const {
        return Illumination{-unit(sun.direction), std::numeric_limits<double>::infinity(), light.color};
    }
};

}  // namespace

std::optional<Illumination> illumination(const Light& light, const Vec3d& point) {
    return std::visit(SeenFrom{light, point}, light.kind);
}

}  // namespace raylab
