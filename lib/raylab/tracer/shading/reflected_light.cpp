#include "raylab/tracer/shading/reflected_light.h"

#include "raylab/geometry/barycentric.h"

namespace raylab {

Color between_corners(const ShadingLight& light, const std::array<LitPoint, 3>& corners, const SurfacePoint& point,
                      const Color& diffuse, const Material& material) {
    const auto color = [&](const LitPoint& corner) -> Color {
        const auto seen = illumination(light, corner.position);
        return seen ? reflected_light(*seen, corner, diffuse, material) : Color{0, 0, 0};
    };
    return interpolate(color(corners[0]), color(corners[1]), color(corners[2]), point.u, point.v);
}

}  // namespace raylab
