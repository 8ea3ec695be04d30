#include "raylab/radiosity/direct_light.h"

#include "raylab/base/tiles.h"
#include "raylab/sampling/even_point.h"
#include "raylab/tracer/shading/illumination.h"

#include <limits>
#include <numbers>

namespace raylab {

namespace {

// The color that arrives at one point of a patch from one light, times the cosine.
Color arriving(const PatchMesh& mesh, const PatchVisibility& visibility, const ShadingLight& light, std::uint32_t patch,
               const Vec3d& point, Traversal& traversal) {
    const auto found = illumination(light, point);
    if (!found) return {0, 0, 0};
    const double cosine = dot(mesh.patches[patch].normal, found->to_light);
    if (!(cosine > 0)) return {0, 0, 0};
    const bool is_seen = light.kind == ShadingLight::Kind::distant
                             ? visibility.sees_direction(patch, point, found->to_light, traversal)
                             : visibility.sees_point(patch, point, light.position, traversal);
    return is_seen ? cosine * found->color : Color{0, 0, 0};
}

}  // namespace

std::vector<Color> direct_light(const PatchMesh& mesh, const PatchVisibility& visibility, int points, int threads) {
    std::vector<Color> light(mesh.patches.size(), Color{0, 0, 0});
    const auto& lights = mesh.model.scene.lights;
    if (lights.empty()) return light;
    const std::vector<ShadingLight> ready(lights.begin(), lights.end());
    for_each_piece(light.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        for (std::size_t i = begin; i < end; ++i) {
            const auto patch = static_cast<std::uint32_t>(i);
            Color sum{0, 0, 0};
            for (int k = 0; k < points; ++k) {
                const auto [u, v] = even_point<2>(k + 1, {0.5, 0.5});
                const Vec3d point = point_of(mesh.patches[patch], u, v);
                for (const ShadingLight& one : ready) sum += arriving(mesh, visibility, one, patch, point, traversal);
            }
            light[i] = std::numbers::pi / points * sum;
        }
    });
    return light;
}

Color background_light(const Background& background) {
    const Color mean = background.zenith ? 0.5 * (background.color + *background.zenith) : background.color;
    return std::numbers::pi * mean;
}

}  // namespace raylab
