// By the box's middle and half sizes.
#include "raylab/geometry/box_entry.h"

#include <algorithm>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double from = ray.range.min, to = ray.range.max;
    for (int i = 0; i < 3; ++i) {
        const double d = ray.direction[i];
        if (d == 0) {
            if (!(low[i] <= ray.origin[i] && ray.origin[i] <= high[i])) return std::nullopt;
        } else {
            const double near = d > 0 ? low[i] : high[i], far = d > 0 ? high[i] : low[i];
            from = std::max(from, (near - ray.origin[i]) / d);
            to = std::min(to, (far - ray.origin[i]) / d);
        }
    }
    return from <= to ? std::optional(from) : std::nullopt;
}
