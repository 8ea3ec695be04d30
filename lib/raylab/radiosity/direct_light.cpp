#include "raylab/radiosity/direct_light.h"

#include "raylab/base/tiles.h"
#include "raylab/sampling/even_point.h"
#include "raylab/scene/mean_of_channels.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace raylab {

PatchLights::PatchLights(const PatchMesh& mesh, const PatchVisibility& visibility)
    : visibility_(visibility), lights_(mesh.model.scene.lights.begin(), mesh.model.scene.lights.end()) {}

// The color that arrives at one point from one light, times the cosine.
Color PatchLights::arriving(const ShadingLight& light, const PatchVisibility::Part& part, const Vec3d& point,
                            Traversal& traversal) const {
    const auto found = illumination(light, point);
    if (!found) return {0, 0, 0};
    const double cosine = dot(part.patch.normal, found->to_light);
    if (!(cosine > 0)) return {0, 0, 0};
    const bool is_seen = light.kind == ShadingLight::Kind::distant
                             ? visibility_.sees_direction(part.of, point, found->to_light, traversal)
                             : visibility_.sees_point(part.of, point, light.position, traversal);
    return is_seen ? cosine * found->color : Color{0, 0, 0};
}

Color PatchLights::at(const PatchVisibility::Part& part, const Vec3d& point, Traversal& traversal) const {
    Color sum{0, 0, 0};
    for (const ShadingLight& light : lights_) sum += arriving(light, part, point, traversal);
    return std::numbers::pi * sum;
}

ArrivingLight PatchLights::on(const PatchVisibility::Part& part, int points, Traversal& traversal) const {
    Color sum{0, 0, 0};
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (int k = 0; k < points; ++k) {
        const auto [u, v] = even_point<2>(k + 1, {0.5, 0.5});
        const Vec3d point = point_of(part.patch, u, v);
        const Color at_point = at(part, point, traversal);
        sum += at_point;
        const double bright = mean_of_channels(at_point);
        least = std::min(least, bright);
        most = std::max(most, bright);
    }
    return {sum / (1.0 * points), most - least};
}

std::vector<Color> direct_light(const PatchMesh& mesh, const PatchVisibility& visibility, int points, int threads) {
    std::vector<Color> light(mesh.patches.size(), Color{0, 0, 0});
    const PatchLights lights(mesh, visibility);
    if (lights.empty()) return light;
    for_each_piece(light.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        for (std::size_t i = begin; i < end; ++i)
            light[i] = lights.on({static_cast<std::uint32_t>(i), mesh.patches[i]}, points, traversal).mean;
    });
    return light;
}

Color background_light(const PatchVisibility::Surroundings& around, double filled) {
    return std::numbers::pi * std::max(0.0, around.with_patches - filled) * around.background;
}

}  // namespace raylab
