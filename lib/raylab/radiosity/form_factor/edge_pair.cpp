#include "raylab/radiosity/form_factor/edge_pair.h"

#include "raylab/radiosity/form_factor/dilogarithm.h"
#include "raylab/radiosity/form_factor/tanh_sinh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raylab {

namespace {

// The antiderivative of ln sqrt(x^2 + d^2).
double log_distance_integral(double x, double d) {
    const double squared = x * x + d * d;
    return squared > 0 ? x * (0.5 * std::log(squared) - 1) + d * std::atan2(x, d) : 0;
}

// The antiderivative of that.
double log_distance_double_integral(double x, double d) {
    const double squared = x * x + d * d;
    if (squared == 0) return 0;
    return 0.5 * (x * (log_distance_integral(x, d) + d * std::atan2(x, d) - 0.5 * x) - 0.5 * d * d * std::log(squared));
}

// The integral of ln r along an edge, with r the distance from a point.
double log_distance_along(const PolygonEdge& edge, const Vec3d& point) {
    const Vec3d way = edge.start - point;
    const double x = dot(way, edge.direction), d = glm::length(cross(way, edge.direction));
    return log_distance_integral(x + edge.length, d) - log_distance_integral(x, d);
}

// Where on an edge the inner integral over another edge is not smooth, or nearly so: at the feet of the other's ends,
// and where the two lines come nearest.
std::array<double, 5> pieces(const PolygonEdge& outer, const PolygonEdge& inner) {
    const auto inside = [&](double s) { return std::clamp(s, 0.0, outer.length); };
    const Vec3d way = inner.start - outer.start, across = cross(outer.direction, inner.direction);
    const double squared = dot(across, across);
    const double start = dot(way, outer.direction), end = start + inner.length * dot(inner.direction, outer.direction);
    const double nearest = squared > 0 ? dot(cross(way, inner.direction), across) / squared : 0;
    std::array<double, 5> ends{0, inside(start), inside(end), inside(nearest), outer.length};
    std::ranges::sort(ends);
    return ends;
}

// Both lines, by their places where they come nearest: with s and t the distances from there,
// r^2 = s^2 + t^2 - 2 s t cosine + apart^2.
struct SkewLines {
    double cosine, sine, apart;
    std::array<double, 2> s, t;  // of the edges' ends
};

// An angle below which directions that are meant to be equal may differ by their rounding.
constexpr double same_direction = 1e-14;

SkewLines skew_lines(const PolygonEdge& a, const PolygonEdge& b) {
    const Vec3d across = cross(a.direction, b.direction), way = b.start - a.start;
    const double sine = glm::length(across);
    const double of_a = dot(cross(way, b.direction), across) / (sine * sine),
                 of_b = dot(cross(way, a.direction), across) / (sine * sine);
    return {dot(a.direction, b.direction),
            sine,
            std::abs(dot(way, across)) / sine,
            {-of_a, a.length - of_a},
            {-of_b, b.length - of_b}};
}

// The double antiderivative of apart / r^2 at s and t, times sine: with s = apart / sine sinh w it is an integral over
// w of the angle under which t is seen, of which two logarithms with e^w in them are left.
double angle_integral(const SkewLines& lines, double s, double t) {
    const double w = std::asinh(s * lines.sine / lines.apart), v = std::asinh(t * lines.sine / lines.apart);
    const std::complex<double> turn(lines.cosine, lines.sine);
    return -(dilogarithm(std::exp(w - v) * turn) + dilogarithm(-std::exp(w + v) * turn)).imag();
}

// The double antiderivative P of ln r at s and t. If all lengths are multiplied by q, P is by q^2 and gets q^2 ln q s t
// in addition; the derivative by q at q = 1 says that 2 P + s t is s dP/ds + t dP/dt + apart dP/d(apart). The first two
// are single integrals of ln r, the last one is that of apart / r^2.
double log_distance_at(const SkewLines& lines, double s, double t) {
    const double from_s = std::hypot(s * lines.sine, lines.apart), from_t = std::hypot(t * lines.sine, lines.apart);
    double twice = s * log_distance_integral(t - lines.cosine * s, from_s) +
                   t * log_distance_integral(s - lines.cosine * t, from_t) - s * t;
    // Lines that meet have no last term; nearer than this it is below the rounding of the others.
    constexpr double meet = 1e-12;
    if (lines.apart > meet * std::hypot(s, t))
        twice += lines.apart * lines.apart / lines.sine * angle_integral(lines, s, t);
    return twice / 2;
}

double skew_edges(const SkewLines& lines) {
    return log_distance_at(lines, lines.s[1], lines.t[1]) - log_distance_at(lines, lines.s[0], lines.t[1]) -
           log_distance_at(lines, lines.s[1], lines.t[0]) + log_distance_at(lines, lines.s[0], lines.t[0]);
}

double parallel_edges(const PolygonEdge& a, const PolygonEdge& b) {
    const Vec3d way = b.start - a.start;
    const double start = dot(way, a.direction), apart = glm::length(cross(way, a.direction));
    const auto [low, high] = std::minmax({start, start + std::copysign(b.length, dot(a.direction, b.direction))});
    const auto at = [&](double x) { return log_distance_double_integral(x, apart); };
    return at(high) - at(high - a.length) - at(low) + at(low - a.length);
}

bool are_parallel(const PolygonEdge& a, const PolygonEdge& b) {
    return glm::length(cross(a.direction, b.direction)) <= same_direction;
}

}  // namespace

double edge_pair_closed(const PolygonEdge& a, const PolygonEdge& b) {
    return are_parallel(a, b) ? parallel_edges(a, b) : skew_edges(skew_lines(a, b));
}

double edge_pair_reach(const PolygonEdge& a, const PolygonEdge& b) {
    if (are_parallel(a, b)) return glm::distance(a.start, b.start) + a.length + b.length;
    const SkewLines lines = skew_lines(a, b);
    return std::max({std::abs(lines.s[0]), std::abs(lines.s[1]), std::abs(lines.t[0]), std::abs(lines.t[1])}) +
           lines.apart;
}

double edge_pair_numerical(const PolygonEdge& a, const PolygonEdge& b) {
    constexpr double tolerance = 1e-12;
    const auto ends = pieces(a, b);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const auto log_distances = [&](double s) {
            return log_distance_along(b, a.start + (ends[i] + s) * a.direction);
        };
        if (ends[i + 1] > ends[i])
            sum += tanh_sinh_integral(log_distances, ends[i + 1] - ends[i], tolerance * a.length * b.length);
    }
    return sum;
}

}  // namespace raylab
