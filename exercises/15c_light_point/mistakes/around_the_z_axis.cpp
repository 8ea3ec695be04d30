// hint: axis_forgotten
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from;
    const double squared = dot(way, way), edge = std::sqrt(1 - radius * radius / squared);
    const double cosine = (1 - v) + v * edge, sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)),
                 phi = 2 * std::numbers::pi * u;
    const LocalFrame frame = frame_around(Vec3d{0, 0, 1});
    const Vec3d direction = sine * std::sin(phi) * frame.x + sine * std::cos(phi) * frame.y + cosine * frame.z;
    const double half = dot(direction, way), root = std::sqrt(std::max(0.0, half * half - squared + radius * radius));
    const Vec3d point = from + (half - root) * direction;
    return {point, 1 / (2 * std::numbers::pi * (1 - edge))};
}
