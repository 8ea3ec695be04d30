// hint: nothing_at_the_edge
// or: not_a_number, one_group
// Takes the root of what rounding may make negative, for rays along the edge.
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from;
    const double distance = glm::length(way), sine_max = radius / distance;
    const double cosine_max = std::sqrt(1 - sine_max * sine_max);
    const double cosine = 1 + u * (cosine_max - 1);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)), turn = 2 * std::numbers::pi * v;
    const Vec3d local{sine * std::cos(turn), sine * std::sin(turn), cosine};
    const Vec3d ray = frame_around(way / distance).to_world(local);
    const double along = dot(ray, way), under = along * along - dot(way, way) + radius * radius;
    return {from + (along - std::sqrt(under)) * ray, 0.5 / (std::numbers::pi * (1 - cosine_max))};
}
