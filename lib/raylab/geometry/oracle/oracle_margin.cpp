#include "raylab/geometry/oracle/oracle_cgal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// Margins measure; they decide nothing. Numbers are exact up to the last step, a square root in double.

namespace raylab::oracle {

namespace {

double square_root(const Rational& x) { return std::sqrt(CGAL::to_double(x)); }

/// Several conditions must hold, each with how far it is from flipping, negative where it fails: what holds is as safe
/// as its weakest condition, what fails as safe as its clearest failure.
double safety(const std::vector<double>& conditions) {
    const double weakest = *std::min_element(conditions.begin(), conditions.end());
    return std::min(std::abs(weakest), 1.0);
}

/// The distance of t from the ends of the range, negative outside, as a length along the line over the size of the
/// whole case.
double room(const Rational& t, const Interval<double>& range, double speed_over_size) {
    double smallest = 1;
    if (std::isfinite(range.min))
        smallest = std::min(smallest, CGAL::to_double(Rational(t - exact(range.min))) * speed_over_size);
    if (std::isfinite(range.max))
        smallest = std::min(smallest, CGAL::to_double(Rational(exact(range.max) - t)) * speed_over_size);
    return smallest;
}

double nearest_finite(const Root& t) {
    constexpr double largest = std::numeric_limits<double>::max();
    return std::clamp(nearest_double(t), -largest, largest);
}

}  // namespace

double margin(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Line line = exact_line(ray);
    const Exact::Point_3 a = exact_point(triangle.a), b = exact_point(triangle.b), c = exact_point(triangle.c);
    const Exact::Vector_3 normal = CGAL::cross_product(b - a, c - a);
    const Piercing piercing = pierce(line, a, normal);
    if (!piercing.t) return 0;

    const Exact::Point_3 p = at(line, *piercing.t);
    const auto reach = [&](const Exact::Point_3& corner) { return (corner - line.origin).squared_length(); };
    const Rational size = std::max({reach(a), reach(b), reach(c)});  // squared
    const double speed = square_root(line.direction.squared_length());
    // An area in the plane, as it is seen along the ray.
    const Rational slope = CGAL::abs(normal * line.direction);
    const auto seen = [&](const Exact::Vector_3& one, const Exact::Vector_3& other) {
        const Rational share = CGAL::cross_product(one, other) * normal / normal.squared_length() / 2;
        return CGAL::to_double(Rational(share * slope / size)) / speed;
    };
    const double decided = safety({seen(b - a, p - a), seen(c - b, p - b), seen(a - c, p - c),
                                   room(*piercing.t, ray.range, speed / square_root(size))});
    return std::min(decided, seen(b - a, c - a));
}

double margin(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    if (sphere.radius < 0) return 0;
    const Line line = exact_line(ray);
    const Exact::Vector_3 from = line.origin - exact_point(sphere.center);
    const Rational squared_speed = line.direction.squared_length(), squared_radius = CGAL::square(exact(sphere.radius));
    const Rational middle = -(from * line.direction) / squared_speed;
    const Rational sagitta = squared_radius - (from + middle * line.direction).squared_length();
    const Rational size = from.squared_length() + squared_radius;
    const double rim = CGAL::to_double(Rational(sagitta / size));
    if (rim <= 0) return std::min(-rim, 1.0);

    const double speed_over_size = square_root(squared_speed / size);
    double smallest = std::min(rim, 1.0);
    const Zeros crossings = zeros({middle * middle - sagitta / squared_speed, -2 * middle, 1});
    for (const auto& [t, slope] : crossings.at)
        smallest = std::min(smallest, std::abs(room(exact(nearest_finite(t)), ray.range, speed_over_size)));
    return smallest;
}

}  // namespace raylab::oracle
