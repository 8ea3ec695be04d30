#include "raylab/accelerator/ray_space/ray_cell.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

// The differences, products and quotients below err by a few units in the last place of their operands.
constexpr double rounding = 16 * unit_roundoff<double>;

struct Range {
    double low, high;
};

double size(const Range& range) { return std::max(std::abs(range.low), std::abs(range.high)); }

// Whether x = u w is possible for some u, and some w of a range that is not negative. The product is linear in each, so
// the ends of the ranges suffice.
bool reaches(const Range& x, const Range& u, const Range& w) {
    const double room = rounding * (size(x) + size(w));
    const double smallest = std::min(u.low * w.low, u.low * w.high),
                 largest = std::max(u.high * w.low, u.high * w.high);
    return !(x.high < smallest - room) &&
           !(x.low > largest + room);  // infinite boxes give NaN, and then it is possible
}

}  // namespace

std::optional<RayPoint> ray_point(const Ray& ray) {
    const Vec3d d = convert<double>(ray.direction), a = glm::abs(d), o = convert<double>(ray.origin);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const double along = a[axis];
    if (!(ray.range.min >= 0) || !(along > 0) || !std::isfinite(a.x + a.y + a.z)) return std::nullopt;
    return RayPoint{
        2 * axis + (d[axis] < 0 ? 1 : 0), {o.x, o.y, o.z, d[(axis + 1) % 3] / along, d[(axis + 2) % 3] / along}, along};
}

bool RayCell::contains(const RayPoint& point) const {
    if (point.face != face) return false;
    for (std::size_t i = 0; i < 5; ++i)
        if (!(point.at[i] >= low[i] && point.at[i] <= high[i])) return false;
    return true;
}

RayCell RayCell::below(std::size_t axis, double cut) const {
    RayCell cell = *this;
    cell.high[axis] = cut;
    return cell;
}

RayCell RayCell::above(std::size_t axis, double cut) const {
    RayCell cell = *this;
    cell.low[axis] = cut;
    return cell;
}

// The vectors from any origin of the cell to any point of the box fill another box; the directions of the cell fill a
// pyramid. The cell's rays may hit the box where the two intersect.
std::optional<double> RayCell::depth_of(const Box& box) const {
    const auto way = [&](int axis) -> Range {
        const auto i = static_cast<std::size_t>(axis);
        return {box.min[axis] - high[i], box.max[axis] - low[i]};
    };
    const int axis = face / 2;
    Range w = way(axis);
    if (face % 2 == 1) w = {-w.high, -w.low};
    if (w.high < 0) return std::nullopt;  // a difference of floats is negative only if it is computed as negative
    w.low = std::max(w.low, 0.0);
    if (!reaches(way((axis + 1) % 3), {low[3], high[3]}, w)) return std::nullopt;
    if (!reaches(way((axis + 2) % 3), {low[4], high[4]}, w)) return std::nullopt;
    return w.low * (1 - rounding);
}

}  // namespace raylab
