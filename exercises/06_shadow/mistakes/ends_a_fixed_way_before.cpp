// hint: ends_before_the_light
// Leaves out the last tenth of a millimetre, in scenes of any size.
#include "raylab/tracer/in_shadow.h"

#include "raylab/geometry/scaled_to_largest_one.h"

#include <algorithm>

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const double largest = std::max(largest_coordinate(point), largest_coordinate(light));
    const Vec3d start = point + 1e-11 * largest * normal, way = light - start;
    if (dot(normal, way) <= 0) return true;
    const auto t = first_hit(start, glm::normalize(way));
    return t && *t + 1e-4 < glm::length(way);
}
