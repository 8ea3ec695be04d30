#pragma once

#include "raylab/tracer/phong_specular.h"
#include "raylab/tracer/shading/illumination.h"
#include "raylab/tracer/shading/surface_point.h"

#include <array>

namespace raylab {

/// A point of a surface as the local model knows it.
struct LitPoint {
    Vec3d position;
    Vec3d normal;     // unit, on the side that is lit
    Vec3d to_viewer;  // unit
};

/// Phong's two terms for light of a colour from a unit direction: I_light (k_diffuse N.L + k_specular cos^n(R, V)),
/// where N.L is known, and positive.
inline Color reflected_light(double cosine, const Vec3d& to_light, const Color& light, const LitPoint& point,
                             const Color& diffuse, const Material& material) {
    if (material.specular == Color{0, 0, 0}) return light * (diffuse * cosine);
    // Copies, which stay in registers: an argument whose address escapes would be kept in memory.
    const Vec3d n = point.normal, l = to_light, v = point.to_viewer;
    const double highlight = phong_specular(n, l, v, material.shininess);
    return light * (diffuse * cosine + material.specular * highlight);
}

/// The same two terms; black where the light is behind the surface.
inline Color reflected_light(const Illumination& light, const LitPoint& point, const Color& diffuse,
                             const Material& material) {
    const double cosine = dot(point.normal, light.to_light);
    if (!(cosine > 0)) return {0, 0, 0};
    return reflected_light(cosine, light.to_light, light.color, point, diffuse, material);
}

/// Gouraud's way: the light is computed at a triangle's corners, and its colour mixed between them with the point's
/// weights. The diffuse colour is the point's own, so that patterns stay sharp. (H. Gouraud: Continuous Shading of
/// Curved Surfaces, IEEE Trans. on Computers 20(6), 1971.)
Color between_corners(const ShadingLight& light, const std::array<LitPoint, 3>& corners, const SurfacePoint& point,
                      const Color& diffuse, const Material& material);

}  // namespace raylab
