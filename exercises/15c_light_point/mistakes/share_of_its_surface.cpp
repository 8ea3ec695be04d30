// hint: pdf_per_area
// Finds the point by the angle at the light's centre, and says how likely it is on the whole of its surface.
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double distance = glm::length(from - center), sine_max = radius / distance, turn = 2 * std::numbers::pi * u;
    const double below = v * (1 - std::sqrt(1 - sine_max * sine_max)), sine = std::sqrt(below * (2 - below));
    // By the law of sines, in the triangle of lit point, point and centre.
    const double at_center = std::asin(std::min(1.0, sine / sine_max)) - std::asin(sine), aside = std::sin(at_center);
    const Vec3d normal = frame_around((from - center) / distance)
                             .to_world({aside * std::cos(turn), aside * std::sin(turn), std::cos(at_center)});
    const double surface = 4 * std::numbers::pi * radius * radius;
    return {center + radius * normal, 1 / surface};
}
