#pragma once

#include "raylab/scene/scene.h"

#include <cmath>
#include <optional>
#include <variant>

namespace raylab {

/// A light as a point sees it, if nothing is in between.
struct Illumination {
    Vec3d to_light;   // unit
    double distance;  // metres; infinite for a distant light
    Color color;      // what arrives: fallen off with distance, dimmed towards a spot's edge
};

namespace detail {

// From a light with a place: it falls off as 1 / (constant + linear d + quadratic d^2).
inline std::optional<Illumination> illumination_from(const Vec3d& position, const Light& light, const Vec3d& point) {
    const Vec3d way = position - point;
    const double distance = glm::length(way);
    if (!(distance > 0)) return std::nullopt;
    const Vec3d& by = light.attenuation;
    const double part = 1 / (by.x + distance * (by.y + distance * by.z));
    if (!std::isfinite(part)) return std::nullopt;  // so near that the quadratic term has vanished
    return Illumination{way / distance, distance, light.color * part};
}

std::optional<Illumination> illumination_of_spot_or_sun(const Light& light, const Vec3d& point);

}  // namespace detail

/// Absent outside a spot's cone, and at the light itself.
inline std::optional<Illumination> illumination(const Light& light, const Vec3d& point) {
    if (const auto* lamp = std::get_if<PointLight>(&light.kind)) return detail::illumination_from(lamp->position, light, point);
    return detail::illumination_of_spot_or_sun(light, point);
}

}  // namespace raylab
