// hint: at_one_distance
// Follows each ray to the plane that touches the light in front.
#include "raylab/geometry/local_frame.h"
#include "raylab/transport/light/light_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double distance = glm::length(center - from), sine_max = radius / distance;
    const double cosine_max = std::sqrt(1 - sine_max * sine_max), turn = 2 * std::numbers::pi * v;
    const double cosine = 1 - u * (1 - cosine_max), sine = std::sqrt(1 - cosine * cosine);
    const LocalFrame frame = frame_around((center - from) / distance);
    const Vec3d ray = frame.to_world({sine * std::cos(turn), sine * std::sin(turn), cosine});
    return {from + (distance - radius) / cosine * ray, 1 / (2 * std::numbers::pi * (1 - cosine_max))};
}
