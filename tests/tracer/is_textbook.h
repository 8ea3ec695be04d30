#pragma once

#include "raylab/scene/scene.h"

#include <algorithm>

namespace raylab::test {

/// Whether the scene has nothing that the textbook does not know (experiment/textbook/textbook_surface.h).
inline bool is_textbook(const Scene& scene) {
    const auto knows = [](const Object& object) {
        const bool known = std::holds_alternative<Sphere>(object.shape) ||
                           std::holds_alternative<Plane>(object.shape) ||
                           std::holds_alternative<Triangle>(object.shape);
        return known && object.placement.is_identity() && object.sides == Sides::both;
    };
    const auto has_place = [](const Light& light) { return !std::holds_alternative<DistantLight>(light.kind); };
    return std::ranges::all_of(scene.objects, knows) && std::ranges::all_of(scene.lights, has_place);
}

}  // namespace raylab::test
