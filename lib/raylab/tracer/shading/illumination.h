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

/// A scene's light, made ready to be asked from many points: what is the same for all of them is computed once.
struct ShadingLight {
    ShadingLight(const Light& light);  // not explicit: where one point is asked, a light will do

    enum class Kind { point, spot, distant } kind;  // in the order of Light::kind
    Color color;
    Vec3d attenuation;
    bool dims;                             // with the distance, or towards the edge of a cone
    Vec3d position{0, 0, 0};               // of a point or a spot
    Vec3d axis{0, 0, 0};                   // unit: the way the light of a distant one or a spot goes
    double min_cosine = -1, exponent = 0;  // of a spot: at the edge of its cone; cos^exponent inside
};

/// The direction and the distance from a point to a light.
struct Bearing {
    Vec3d to_light;   // unit; NaN at the light itself
    double distance;  // metres; infinite for a distant light
};

inline Bearing bearing(const ShadingLight& light, const Vec3d& point) {
    if (light.kind == ShadingLight::Kind::distant) return {-light.axis, std::numeric_limits<double>::infinity()};
    const Vec3d way = light.position - point;
    const double distance = glm::length(way);
    return {way * (1 / distance), distance};
}

/// The colour that arrives from a light that dims. Absent outside a spot's cone, and where it is too near to say.
std::optional<Color> dimmed(const ShadingLight& light, const Bearing& toward);

/// The colour that arrives from any light. Absent where none does: outside a spot's cone, and at the light itself.
inline std::optional<Color> incident_color(const ShadingLight& light, const Bearing& toward) {
    if (!(toward.distance > 0)) return std::nullopt;
    if (!light.dims) return light.color;
    return dimmed(light, toward);
}

/// A light as a point sees it. Absent where no light arrives.
inline std::optional<Illumination> illumination(const ShadingLight& light, const Vec3d& point) {
    const Bearing toward = bearing(light, point);
    const auto color = incident_color(light, toward);
    if (!color) return std::nullopt;
    return Illumination{toward.to_light, toward.distance, *color};
}

}  // namespace raylab
