#include "raylab/radiosity/form_factor/rectangle_form_factor.h"

#include "raylab/radiosity/form_factor/closed_forms.h"
#include "raylab/radiosity/form_factor/convex_polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raylab {

namespace {

constexpr double rounding = 1e-13;  // of coordinates, in units of the polygons' size
constexpr double digits = 1e-12;    // the relative error up to which an answer is given
using std::numbers::pi;

struct Range {
    double low, high;
    double length() const { return high - low; }
};

// A rectangle with edges parallel to the axes. The normal is along axis `flat`, where low equals high.
struct AxisRectangle {
    std::array<Range, 3> range;
    std::size_t flat;
    double facing;  // 1 or -1: along the axis or against it

    double height() const { return range[flat].low; }
};

// A polygon of four vertices, in a frame of axes.
std::optional<AxisRectangle> axis_rectangle(std::span<const Vec3d> polygon, const Vec3d& origin,
                                            const std::array<Vec3d, 3>& axes, double tolerance) {
    if (polygon.size() != 4) return std::nullopt;
    AxisRectangle found{};
    int flat_axes = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<double, 4> at{};
        for (std::size_t i = 0; i < 4; ++i) at[i] = dot(axes[axis], polygon[i] - origin);
        const auto [low, high] = std::ranges::minmax(at);
        for (const double x : at)
            if (x > low + tolerance && x < high - tolerance) return std::nullopt;
        found.range[axis] = {low, high};
        if (high - low <= tolerance) {
            ++flat_axes;
            found.flat = axis;
            found.range[axis] = {0.5 * (low + high), 0.5 * (low + high)};
        }
    }
    if (flat_axes != 1) return std::nullopt;
    found.facing = dot(axes[found.flat], area_vector(polygon)) > 0 ? 1 : -1;
    return found;
}

// An alternating sum, with the sum of the absolute values, from which its error follows.
struct AlternatingSum {
    double value = 0, magnitude = 0;

    void add(int sign, double term) {
        value += sign * term;
        magnitude += std::abs(term);
    }
    bool cancels() const { return magnitude * 0x1p-51 > digits * std::abs(value); }
};

double times_atan(double a, double b, double distance) {
    const double root = std::hypot(b, distance);
    return a * root * std::atan2(a, root);
}

// Howell's C-13 without its factor 1 / (2 pi); x and y are differences of coordinates.
double parallel_term(double x, double y, double distance) {
    const double squared = x * x + y * y + distance * distance;
    return times_atan(x, y, distance) + times_atan(y, x, distance) - 0.5 * distance * distance * std::log(squared);
}

// The fourfold antiderivative of the kernel between perpendicular rectangles, without its factor 1 / (4 pi): x is the
// difference along the common direction, y and z are the distances from the line where the planes meet.
double perpendicular_term(double x, double y, double z) {
    const double q = std::hypot(y, z), squared = x * x + q * q;
    return squared > 0 ? 0.5 * (x - q) * (x + q) * std::log(squared) + 2 * x * q * std::atan2(x, q) : 0;
}

// The sum of terms over the ends of four ranges, with a minus for each lower end; the first two enter by their
// difference.
template <class Term>
AlternatingSum over_ends(const Range& a, const Range& b, const Range& c, const Range& d, const Term& term) {
    AlternatingSum sum;
    for (int ends = 0; ends < 16; ++ends) {
        const auto end = [ends](const Range& range, int bit) {
            return (ends >> bit & 1) != 0 ? range.high : range.low;
        };
        const int lower_ends = 4 - (ends & 1) - (ends >> 1 & 1) - (ends >> 2 & 1) - (ends >> 3);
        sum.add(lower_ends % 2 == 0 ? 1 : -1, term(end(a, 0), end(b, 1), end(c, 2), end(d, 3)));
    }
    return sum;
}

Range in_front(const Range& range, double plane, double facing) {
    const double a = std::max(0.0, facing * (range.low - plane)), b = std::max(0.0, facing * (range.high - plane));
    return {std::min(a, b), std::max(a, b)};
}

// `from` lies at height 0 of axis 2, and faces up.
std::optional<double> parallel(const AxisRectangle& from, const AxisRectangle& to, double tolerance) {
    const double distance = to.height();
    if (distance <= tolerance || to.facing > 0) return 0;
    const bool opposite = std::abs(to.range[0].low) <= tolerance && std::abs(to.range[1].low) <= tolerance &&
                          std::abs(to.range[0].length() - from.range[0].length()) <= tolerance &&
                          std::abs(to.range[1].length() - from.range[1].length()) <= tolerance;
    if (opposite) return parallel_rectangles(from.range[0].length() / distance, from.range[1].length() / distance);
    const auto sum = over_ends(
        from.range[0], to.range[0], from.range[1], to.range[1],
        [&](double x, double x_to, double y, double y_to) { return parallel_term(x_to - x, y_to - y, distance); });
    if (sum.cancels()) return std::nullopt;
    return sum.value / (2 * pi * from.range[0].length() * from.range[1].length());
}

std::optional<double> perpendicular(const AxisRectangle& from, const AxisRectangle& to, double tolerance) {
    const std::size_t along = 1 - to.flat;  // the axis in which both rectangles have a side
    const Range seen = in_front(from.range[to.flat], to.height(), to.facing), risen = in_front(to.range[2], 0, 1);
    if (seen.length() <= tolerance || risen.length() <= tolerance) return 0;
    const auto sum =
        over_ends(from.range[along], to.range[along], seen, risen,
                  [](double x, double x_to, double y, double z) { return perpendicular_term(x_to - x, y, z); });
    if (sum.cancels()) return std::nullopt;
    return sum.value / (4 * pi * from.range[0].length() * from.range[1].length());
}

}  // namespace

std::optional<double> rectangle_form_factor(std::span<const Vec3d> from, std::span<const Vec3d> to) {
    if (from.size() != 4 || to.size() != 4) return std::nullopt;
    // In units of the polygons' size, from a corner of the first, along its edges and its normal.
    const double unit = polygon_ball(from).radius + polygon_ball(to).radius;
    const Vec3d x = glm::normalize(from[1] - from[0]), normal = polygon_normal(from);
    const std::array<Vec3d, 3> axes{x / unit, cross(normal, x) / unit, normal / unit};
    const auto sender = axis_rectangle(from, from[0], axes, rounding),
               receiver = axis_rectangle(to, from[0], axes, rounding);
    if (!sender || !receiver) return std::nullopt;
    return receiver->flat == 2 ? parallel(*sender, *receiver, rounding) : perpendicular(*sender, *receiver, rounding);
}

}  // namespace raylab
