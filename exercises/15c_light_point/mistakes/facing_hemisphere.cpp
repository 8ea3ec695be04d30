// hint: facing_hemisphere
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const LocalFrame frame = frame_around(glm::normalize(from - center));
    const double cosine = u, sine = std::sqrt(1 - cosine * cosine), angle = 2 * std::numbers::pi * v;
    const Vec3d normal = frame.to_world({sine * std::cos(angle), sine * std::sin(angle), cosine});
    const Vec3d point = center + radius * normal, way = from - point;
    const double squared = dot(way, way), slant = std::abs(dot(way, normal)) / std::sqrt(squared);
    return {point, squared / (slant * 2 * std::numbers::pi * radius * radius)};
}
