#include "raylab/radiosity/form_factor/closed_forms.h"

#include "raylab/radiosity/form_factor/gauss_legendre.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab {

using std::numbers::pi;

double parallel_rectangles_textbook(double x, double y) {
    const double x2 = x * x, y2 = y * y, root_x = std::sqrt(1 + x2), root_y = std::sqrt(1 + y2);
    return 2 / (pi * x * y) *
           (0.5 * std::log((1 + x2) * (1 + y2) / (1 + x2 + y2)) + x * root_y * std::atan(x / root_y) +
            y * root_x * std::atan(y / root_x) - x * std::atan(x) - y * std::atan(y));
}

double parallel_rectangles(double x, double y) {
    const auto [narrow, wide] = std::minmax(x, y);
    if (narrow > 1) return parallel_rectangles_textbook(x, y);
    // Of the four integrals over both rectangles two are over sums, which leave the factors 1 - s and 1 - t; then
    // F = 4/pi x y integral of (1 - s)(1 - t) / (1 + x^2 s^2 + y^2 t^2)^2 over the unit square. That over s is closed.
    double sum = 0;
    for (const auto [t, weight] : gauss_legendre(most_gauss_points)) {
        const double k = std::hypot(1, narrow * t);
        sum += weight * (1 - t) * std::atan(wide / k) / (k * k * k);
    }
    return 2 * narrow / pi * sum;
}

double perpendicular_rectangles(double h, double w) {
    const double h2 = h * h, w2 = w * w, all = 1 + w2 + h2, diagonal = std::sqrt(h2 + w2);
    const double logarithms = std::log((1 + w2) * (1 + h2) / all) + w2 * std::log(w2 * all / ((1 + w2) * (w2 + h2))) +
                              h2 * std::log(h2 * all / ((1 + h2) * (h2 + w2)));
    return (w * std::atan(1 / w) + h * std::atan(1 / h) - diagonal * std::atan(1 / diagonal) + 0.25 * logarithms) /
           (pi * w);
}

double coaxial_disks(double from_radius, double to_radius, double distance) {
    const double nearest = std::hypot(distance, from_radius - to_radius);  // between points of the two rims
    const double farthest = std::hypot(distance, from_radius + to_radius);
    const double sum = distance * distance + from_radius * from_radius + to_radius * to_radius;
    return 2 * to_radius * to_radius / (sum + nearest * farthest);
}

double sphere_to_disk(double disk_radius, double distance) {
    const double x = disk_radius / distance, root = std::hypot(1, x);
    return x * x / (2 * root * (1 + root));  // (1 - 1/root) / 2
}

double element_to_disk(double disk_radius, double distance) {
    const double x = disk_radius / distance;
    return x * x / (1 + x * x);
}

double element_to_parallel_rectangle(double a, double b, double distance) {
    const double x = a / distance, y = b / distance, root_x = std::hypot(1, x), root_y = std::hypot(1, y);
    return (x / root_x * std::atan(y / root_x) + y / root_y * std::atan(x / root_y)) / (2 * pi);
}

double element_to_perpendicular_rectangle(double height, double width, double distance) {
    const double slant = std::hypot(distance, height);
    return (std::atan2(width, distance) - distance / slant * std::atan2(width, slant)) / (2 * pi);
}

double element_to_sphere(double radius, double distance, double angle) {
    const double h = distance / radius, root = std::sqrt((h - 1) * (h + 1)), cosine = std::cos(angle);
    const double half_width = std::asin(1 / h);  // the angle under which the sphere's radius is seen
    if (angle + half_width <= pi / 2) return cosine / (h * h);
    if (angle - half_width >= pi / 2) return 0;
    const double sine = std::sin(angle), below = std::sqrt((1 - h * cosine) * (1 + h * cosine));
    return 0.5 - std::asin(root / (h * sine)) / pi +
           (cosine * std::acos(-root * cosine / sine) - root * below) / (pi * h * h);
}

}  // namespace raylab
