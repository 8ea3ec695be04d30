// hint: disk_through_the_center
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from;
    const double distance = glm::length(way), r = radius * std::sqrt(u), angle = 2 * std::numbers::pi * v;
    const LocalFrame frame = frame_around(way / distance);
    const Vec3d point = center + r * std::cos(angle) * frame.x + r * std::sin(angle) * frame.y;
    const double squared = dot(point - from, point - from), cosine = distance / std::sqrt(squared);
    return {point, squared / (cosine * std::numbers::pi * radius * radius)};
}
