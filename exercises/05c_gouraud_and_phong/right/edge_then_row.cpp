// As hardware did it: along the edge between the second and the third vertex, then along the row from the first.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double across = hit.u + hit.v, down = across > 0 ? hit.v / across : 0;
    const auto between = [](const auto& from, const auto& to, double t) { return (1 - t) * from + t * to; };
    const auto mix = [&](const auto& a, const auto& b, const auto& c) {
        return between(a, between(b, c, down), across);
    };
    const auto& [a, b, c] = hit.normals;
    Vec3d normal = mix(a, b, c);
    if (normal == Vec3d{0, 0, 0}) normal = hit.face;
    return {mix(brightness(side * a), brightness(side * b), brightness(side * c)),
            brightness(side * glm::normalize(normal))};
}
