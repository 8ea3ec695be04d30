#pragma once

#include "raylab/accelerator/light_buffer/silhouette.h"
#include "raylab/geometry/intersect/nearest.h"

#include <optional>

namespace raylab {

/// The hull of a primitive as seen from a light, blurred by so much and by what its corners were rounded. Triangles,
/// polygons and balls as they are; anything else by its box. Absent where it has no bounds.
std::optional<Silhouette::Hull> hull_from(const Vec3d& light, const Target& target, double blur);

}  // namespace raylab
