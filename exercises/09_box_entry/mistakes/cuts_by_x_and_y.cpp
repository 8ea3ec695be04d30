// hint: all_three
// Cuts the range by each axis by hand, as one does it with a rectangle: by x and by y.
#include "raylab/geometry/box_entry.h"

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double from = ray.range.min, to = ray.range.max;
    const auto cut = [&from, &to](double origin, double speed, double begin, double end) {
        if (speed == 0) return begin <= origin && origin <= end;
        const double enters = ((speed > 0 ? begin : end) - origin) / speed;
        const double leaves = ((speed > 0 ? end : begin) - origin) / speed;
        if (enters > from) from = enters;
        if (leaves < to) to = leaves;
        return from <= to;
    };
    if (!cut(ray.origin.x, ray.direction.x, low.x, high.x)) return std::nullopt;
    if (!cut(ray.origin.y, ray.direction.y, low.y, high.y)) return std::nullopt;
    return from;
}
