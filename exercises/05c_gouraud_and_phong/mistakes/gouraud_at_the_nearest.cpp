// hint: nearest_vertex
// Gouraud without mixing.
#include "raylab/tracer/gouraud_and_phong.h"

#include <algorithm>

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const std::array<double, 3> weights{1 - hit.u - hit.v, hit.u, hit.v};
    const auto nearest = static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin());
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) sum += side * weights[i] * hit.normals[i];
    if (sum == Vec3d{0, 0, 0}) sum = side * hit.face;
    return {brightness(side * hit.normals[nearest]), brightness(glm::normalize(sum))};
}
