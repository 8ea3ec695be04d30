// hint: even_angle
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double below = std::numbers::pi / 2 * u, angle = 2 * std::numbers::pi * v;
    const double sine = std::sin(below), cosine = std::cos(below);
    return {{sine * std::cos(angle), sine * std::sin(angle), cosine}, cosine / std::numbers::pi};
}
