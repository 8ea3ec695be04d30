#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// Phong's highlight: cos^shininess of the angle between the viewer and the mirror direction of the light, 0 where that
/// angle is a right one or more, and where the light is behind the surface or in its plane. Vectors point away from the
/// surface and may have any length but zero; shininess >= 0. (Phong: Illumination for Computer Generated Pictures, CACM
/// 18(6), 1975.) This is the slot of exercise 05.
double phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess);

}  // namespace raylab
