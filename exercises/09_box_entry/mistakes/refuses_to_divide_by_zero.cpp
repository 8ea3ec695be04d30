// hint: parallel
// Is careful not to divide by 0, and so gives none where a coordinate of the direction is 0.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    const Vec3d& d = ray.direction;
    if (d.x == 0 || d.y == 0 || d.z == 0) return std::nullopt;

    const Vec3d at_low = (low - ray.origin) / d, at_high = (high - ray.origin) / d;
    const Vec3d entries = glm::min(at_low, at_high), exits = glm::max(at_low, at_high);
    const double entry = std::max({ray.range.min, entries.x, entries.y, entries.z});
    const double exit = std::min({ray.range.max, exits.x, exits.y, exits.z});
    if (entry > exit) return std::nullopt;
    return entry;
}
