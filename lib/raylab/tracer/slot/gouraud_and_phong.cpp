#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const auto& [normals, face, u, v, to_viewer] = hit;
    const double side = dot(face, to_viewer) < 0 ? -1 : 1;  // one for the whole triangle, or it would tear
    const std::array weights{1 - u - v, u, v};
    double gouraud = 0;
    Vec3d mixed{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        gouraud += weights[i] * brightness(side * normals[i]);
        mixed += weights[i] * side * normals[i];
    }
    const Vec3d normal = mixed == Vec3d{0, 0, 0} ? side * face : glm::normalize(mixed);
    return {gouraud, brightness(normal)};
}
