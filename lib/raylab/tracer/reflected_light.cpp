#include "raylab/tracer/reflected_light.h"

#include "raylab/geometry/barycentric.h"
#include "raylab/tracer/phong_specular.h"

namespace raylab {

Color reflected_light(const Illumination& light, const LitPoint& point, const Color& diffuse,
                      const Material& material) {
    const double cosine = dot(point.normal, light.to_light);
    if (!(cosine > 0)) return {0, 0, 0};
    Color reflected = diffuse * cosine;
    if (material.specular != Color{0, 0, 0})
        reflected +=
            material.specular * phong_specular(point.normal, light.to_light, point.to_viewer, material.shininess);
    return light.color * reflected;
}

Color between_corners(const Light& light, const std::array<LitPoint, 3>& corners, const SurfacePoint& point,
                      const Color& diffuse, const Material& material) {
    const auto color = [&](const LitPoint& corner) -> Color {
        const auto seen = illumination(light, corner.position);
        return seen ? reflected_light(*seen, corner, diffuse, material) : Color{0, 0, 0};
    };
    return interpolate(color(corners[0]), color(corners[1]), color(corners[2]), point.u, point.v);
}

}  // namespace raylab
