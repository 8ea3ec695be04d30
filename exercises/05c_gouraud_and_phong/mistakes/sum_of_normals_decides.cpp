// hint: side_of_each
// The vertices' normals together say which side is seen.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const auto& [first, second, third] = hit.normals;
    const double side = dot(first + second + third, hit.to_viewer) < 0 ? -1 : 1;
    const double w = 1 - hit.u - hit.v;
    const double gouraud =
        w * brightness(side * first) + hit.u * brightness(side * second) + hit.v * brightness(side * third);
    const Vec3d sum = w * first + hit.u * second + hit.v * third;
    const Vec3d normal = glm::length(sum) == 0 ? hit.face : glm::normalize(sum);
    return {gouraud, brightness(side * normal)};
}
