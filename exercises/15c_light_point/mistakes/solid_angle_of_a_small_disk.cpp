// hint: pdf_of_a_flat_light
// Works in radii from the light's centre. The solid angle is pi times the sine squared, as if the light were flat.
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double away = glm::length(from - center) / radius, sine_squared = 1 / (away * away);
    const double below = (1 - std::sqrt(1 - sine_squared)) * u, across_squared = below * (2 - below);
    const double t = away * (1 - below) - std::sqrt(std::max(0.0, 1 - away * away * across_squared));
    const double aside = t * std::sqrt(across_squared), turn = 2 * std::numbers::pi * v;
    const LocalFrame frame = frame_around((from - center) / (away * radius));
    const Vec3d place{aside * std::cos(turn), aside * std::sin(turn), away - t * (1 - below)};
    return {center + radius * frame.to_world(place), 1 / (std::numbers::pi * sine_squared)};
}
