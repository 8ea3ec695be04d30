// hint: outside_the_cone
// or: not_a_number
// The cosine goes from 1 down to 1 - cos_max, and most rays miss the light.
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const Vec3d way = center - from;
    const double distance = glm::length(way), sine_max = radius / distance;
    const double cosine_max = std::sqrt(1 - sine_max * sine_max);
    const double cosine = 1 - u * cosine_max;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)), turn = 2 * std::numbers::pi * v;
    const Vec3d local{sine * std::cos(turn), sine * std::sin(turn), cosine};
    const Vec3d ray = frame_around(way / distance).to_world(local);
    const double under = radius * radius - distance * distance * sine * sine;
    return {from + (distance * cosine - std::sqrt(under)) * ray, 0.5 / (std::numbers::pi * (1 - cosine_max))};
}
