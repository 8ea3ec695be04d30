#pragma once

#include "raylab/scene/scene.h"

#include <optional>

namespace raylab {

/// A light as a point sees it, if nothing is in between.
struct Illumination {
    Vec3d to_light;   // unit
    double distance;  // metres; infinite for a distant light
    Color color;      // what arrives: fallen off with distance, dimmed towards a spot's edge
};

/// Absent outside a spot's cone, and at the light itself.
std::optional<Illumination> illumination(const Light& light, const Vec3d& point);

}  // namespace raylab
