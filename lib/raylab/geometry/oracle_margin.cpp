#include "raylab/geometry/oracle_numbers.h"

#include <algorithm>
#include <cmath>

namespace raylab::oracle {

namespace {

/// The relative distance of a sum from zero: |sum| over the sum of its terms' sizes. Scale-free, and at most 1.
double distance_from_zero(const Rational& sum, const Rational& size) {
    return size == 0 ? 0 : CGAL::to_double(Rational(CGAL::abs(sum) / size));
}

double relative_difference(double a, double b) {
    const double size = std::max(std::abs(a), std::abs(b));
    return size == 0 ? 0 : std::isinf(size) ? 1 : std::abs(a - b) / size;
}

/// How far a t is from the ends of the range; an end at zero is as far away as t is from the ray's whole reach to it.
double distance_from_ends(double t, double reach, const Interval<double>& range) {
    const double size = std::max(std::abs(t), reach);
    const auto from = [&](double end) { return std::isinf(end) ? 1.0 : end == 0 ? std::abs(t) / size : relative_difference(t, end); };
    return std::min({1.0, from(range.min), from(range.max)});
}

}  // namespace

double margin(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Line line = exact_line(ray);
    const Exact::Point_3 a = exact_point(triangle.a), b = exact_point(triangle.b), c = exact_point(triangle.c);
    const Exact::Vector_3 normal = CGAL::cross_product(b - a, c - a);
    const Rational slope = normal * line.direction;
    if (slope == 0) return 0;
    const Rational size = CGAL::abs(normal.x() * line.direction.x()) + CGAL::abs(normal.y() * line.direction.y()) +
                          CGAL::abs(normal.z() * line.direction.z());
    const Rational t = normal * (a - line.origin) / slope;
    const Exact::Vector_3 hit = at(line, t) - a;
    // The weights of the plane's point: each is zero on its edge, and they sum to one.
    const Rational area = normal.squared_length();
    const Rational v = normal * CGAL::cross_product(b - a, hit) / area;
    const Rational u = normal * CGAL::cross_product(hit, c - a) / area;
    const Rational w = 1 - u - v;
    const Rational weights = CGAL::abs(u) + CGAL::abs(v) + CGAL::abs(w);
    const double edges = std::min({distance_from_zero(u, weights), distance_from_zero(v, weights), distance_from_zero(w, weights)});
    return std::min({edges, distance_from_zero(slope, size), distance_from_ends(CGAL::to_double(t), 0, ray.range)});
}

double margin(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    const Line line = exact_line(ray);
    const Exact::Vector_3 from = line.origin - exact_point(sphere.center);
    const Rational squared_radius = CGAL::square(exact(sphere.radius));
    const Rational closest = -(from * line.direction) / line.direction.squared_length();
    const Rational miss = (from + closest * line.direction).squared_length();
    const double rim = distance_from_zero(miss - squared_radius, miss + squared_radius);
    if (miss > squared_radius) return rim;
    const double middle = CGAL::to_double(closest);
    const double half = std::sqrt(CGAL::to_double(Rational((squared_radius - miss) / line.direction.squared_length())));
    return std::min({rim, distance_from_ends(middle - half, std::abs(middle) + half, ray.range),
                     distance_from_ends(middle + half, std::abs(middle) + half, ray.range)});
}

}  // namespace raylab::oracle
