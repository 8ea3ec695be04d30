#pragma once

#include "raylab/scene/scene.h"

#include <limits>
#include <optional>

namespace raylab {

/// A light as a point sees it, if nothing is in between.
struct Illumination {
    Vec3d to_light;   // unit
    double distance;  // metres; infinite for a distant light
    Color color;      // what arrives: fallen off with distance, dimmed towards a spot's edge
};

/// A scene's light, made ready to be asked from many points: what is the same for all of them is reckoned once.
struct Lamp {
    Lamp(const Light& light);  // not explicit: where one point is asked, a light will do

    enum class Kind { point, spot, distant } kind;  // in the order of Light::kind
    Color color;
    Vec3d attenuation;
    bool dims;                                // with the distance, or towards the edge of a cone
    Vec3d position{0, 0, 0};                  // of a point or a spot
    Vec3d axis{0, 0, 0};                      // unit: the way the light of a distant one or a spot goes
    double least_cosine = -1, exponent = 0;  // of a spot: at the edge of its cone; cos^exponent inside
};

namespace detail {

// The colour of a lamp's light that arrives in a unit direction after a distance; absent: none does.
std::optional<Color> dimmed(const Lamp& lamp, Vec3d to_light, double distance);

}  // namespace detail

/// Of a lamp that is known to be a point and to shine alike at any distance. At the light itself the direction is NaN.
inline Illumination plain_illumination(const Lamp& lamp, const Vec3d& point) {
    Vec3d way = lamp.position - point;
    const double distance = glm::length(way);
    return {way / distance, distance, lamp.color};
}

/// Absent outside a spot's cone, and at the light itself.
[[gnu::always_inline]] inline std::optional<Illumination> illumination(const Lamp& lamp, const Vec3d& point) {
    if (lamp.kind == Lamp::Kind::distant) return Illumination{-lamp.axis, std::numeric_limits<double>::infinity(), lamp.color};
    Illumination light = plain_illumination(lamp, point);
    if (!(light.distance > 0)) return std::nullopt;
    if (!lamp.dims) return light;
    auto color = detail::dimmed(lamp, light.to_light, light.distance);
    if (!color) return std::nullopt;
    light.color = *color;
    return light;
}

}  // namespace raylab
