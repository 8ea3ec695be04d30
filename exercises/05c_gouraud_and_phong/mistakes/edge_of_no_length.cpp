// hint: not_a_number
// Goes from the first vertex to a point between the two others, which is 0 / 0 at the first vertex.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double far = hit.u + hit.v, second = hit.u / far, third = hit.v / far;
    const auto mixed = [&](const auto& a, const auto& b, const auto& c) {
        return (1 - far) * a + far * (second * b + third * c);
    };
    const auto& [a, b, c] = hit.normals;
    const Vec3d sum = mixed(a, b, c);
    const Vec3d normal = sum == Vec3d{0, 0, 0} ? hit.face : glm::normalize(sum);
    return {mixed(brightness(side * a), brightness(side * b), brightness(side * c)), brightness(side * normal)};
}
