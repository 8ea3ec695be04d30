// hint: flat
// The triangle's own normal for both.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const Vec3d normal = dot(hit.face, hit.to_viewer) < 0 ? -hit.face : hit.face;
    return {brightness(normal), brightness(normal)};
}
