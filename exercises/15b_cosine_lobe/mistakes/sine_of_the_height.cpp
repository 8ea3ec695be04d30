// hint: too_near_the_horizon
// The root is taken of the sine instead of the number.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double sine = std::sqrt(std::sqrt(u)), cosine = std::sqrt(1 - sine * sine);
    const double angle = 2 * std::numbers::pi * v;
    return {{sine * std::sin(angle), sine * std::cos(angle), cosine}, cosine / std::numbers::pi};
}
