#include "raylab/accelerator/bvh8/ray_in_mesh.h"

#include "raylab/geometry/largest_coordinate.h"
#include "raylab/number/enclosure.h"
#include "raylab/number/next_float.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

constexpr double u = unit_roundoff<double>, float_u = unit_roundoff<float>;

// The range of t in which the ray is inside of the box, slightly too large: a difference and a quotient of floats have
// two roundings. An axis along which the ray stands still is left out.
Interval<double> inside(const Ray& ray, double end, const Box& box) {
    Interval<double> range{ray.range.min, end};
    for (int axis = 0; axis < 3; ++axis) {
        const double direction = ray.direction[axis], origin = ray.origin[axis];
        if (direction == 0) continue;
        const bool forward = direction > 0;
        const double in = ((forward ? box.min : box.max)[axis] - origin) / direction;
        const double out = ((forward ? box.max : box.min)[axis] - origin) / direction;
        range.min = std::max(range.min, in - 4 * u * std::abs(in));
        range.max = std::min(range.max, out + 4 * u * std::abs(out));
    }
    return range;
}

// The power of two at a number, so that dividing by it rounds nothing.
double power_at(double x) { return std::ldexp(1.0, std::ilogb(x)); }

// A component that is nearly zero becomes zero, because floats cannot divide by the smallest numbers.
Vec3f direction_in_floats(const Vec3d& direction) {
    constexpr double smallest = 0x1p-40;
    const auto component = [](double x) { return std::abs(x) < smallest ? 0.0f : cast<float>(x); };
    return {component(direction.x), component(direction.y), component(direction.z)};
}

}  // namespace

double RayInMesh::at_most(double t) const { return ((t - from) + 4 * u * (std::abs(t) + std::abs(from))) * scale; }

std::optional<WorldToMesh> WorldToMesh::inverse_of(const Affine& placement) {
    const auto x = convert<Enclosure>(placement.columns[0]), y = convert<Enclosure>(placement.columns[1]),
               z = convert<Enclosure>(placement.columns[2]);
    const std::array<Vec3<Enclosure>, 3> adjugate{cross(y, z), cross(z, x), cross(x, y)};
    const Enclosure determinant = dot(x, adjugate[0]);
    WorldToMesh map;
    map.placement_ = placement;
    map.error_ = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::array row{adjugate[i].x / determinant, adjugate[i].y / determinant, adjugate[i].z / determinant};
        double error = 0;
        for (const Enclosure& entry : row) error += entry.radius() + 8 * u * std::abs(entry.middle());
        map.rows_[i] = {row[0].middle(), row[1].middle(), row[2].middle()};
        map.error_ = std::max(map.error_, error);
        // Bounds grown by an error as large as the map itself would hold every triangle.
        if (!(error < 0x1p-20 * largest_coordinate(map.rows_[i]))) return std::nullopt;
    }
    return map;
}

// A coordinate of the exact ray at t is m v + t m d, with v the origin as seen from the translation. In doubles the
// image of v and that of d err by error_ times their largest coordinates (which has room for the rounding of v, and of
// products and sums: 6 u for each entry), and the step to where the ray begins by 3 u. In floats, begin and direction
// are rounded once, or the direction to zero below 2^-40; what is a float's rounding of the begin is given three times,
// because the boxes' tests want it, too.
std::optional<RayInMesh> WorldToMesh::carried(const Ray& ray, double end, const Box& bounds) const {
    const auto [from, to] = inside(ray, end, bounds);
    if (!(from <= to) || ray.direction == Vec3f(0)) return std::nullopt;
    const Vec3d v = convert<double>(ray.origin) - convert<double>(placement_.translation),
                d = convert<double>(ray.direction);
    const auto image = [&](const Vec3d& of) { return Vec3d{dot(rows_[0], of), dot(rows_[1], of), dot(rows_[2], of)}; };
    const Vec3d origin = image(v), direction = image(d), begin = origin + from * direction;
    const double steepest = largest_coordinate(direction), farthest = std::max(std::abs(from), std::abs(to));
    RayInMesh result{.ray = {}, .from = from, .scale = 1, .displacement = std::numeric_limits<float>::infinity()};
    if (!(steepest > 0x1p-500 && steepest < 0x1p500)) return result;
    result.scale = power_at(steepest);
    const double length = (to - from) * result.scale;
    const double in_doubles = error_ * (largest_coordinate(v) + farthest * largest_coordinate(d)) +
                              4 * u * (largest_coordinate(origin) + farthest * steepest);
    const double in_floats = float_u * (3 * largest_coordinate(begin) + 4 * length);
    const double displacement = (in_doubles + in_floats) * (1 + 0x1p-10) + 0x1p-100;
    if (!(displacement < 0x1p39)) return result;
    result.ray = {
        convert<float>(begin), direction_in_floats(direction / result.scale), {0, rounded_up(length * (1 + 4 * u))}};
    result.displacement = rounded_up(displacement);
    return result;
}

}  // namespace raylab
