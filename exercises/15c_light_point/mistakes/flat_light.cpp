// hint: disk_through_the_center
#include "raylab/transport/light/light_point.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from, axis = glm::normalize(way);
    const Vec3d x = glm::normalize(cross(axis, std::abs(axis.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    const auto place = std::polar(radius * std::sqrt(v), 2 * std::numbers::pi * u);
    const double edge = std::sqrt(1 - radius * radius / dot(way, way));
    return {center + place.real() * x + place.imag() * cross(axis, x), 0.5 * std::numbers::inv_pi / (1 - edge)};
}
