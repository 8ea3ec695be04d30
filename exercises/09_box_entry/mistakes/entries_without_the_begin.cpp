// hint: range
// The answer is the latest of three entries, and the beginning of the range is not among them.
#include "raylab/geometry/box_entry.h"

#include <algorithm>
#include <limits>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3d entries(-infinity), exits(infinity);
    for (int i = 0; i < 3; ++i) {
        const double to_low = low[i] - ray.origin[i], to_high = high[i] - ray.origin[i], d = ray.direction[i];
        if (d == 0 && (to_low > 0 || to_high < 0)) return std::nullopt;
        if (d == 0) continue;
        entries[i] = (d > 0 ? to_low : to_high) / d;
        exits[i] = (d > 0 ? to_high : to_low) / d;
    }
    const double entry = std::max({entries.x, entries.y, entries.z});
    const double exit = std::min({exits.x, exits.y, exits.z, ray.range.max});
    return entry <= exit ? std::optional(entry) : std::nullopt;
}
