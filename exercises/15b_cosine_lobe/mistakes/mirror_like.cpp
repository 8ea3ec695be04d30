// hint: too_near_z
// The lobe of a glossy surface: a power of the cosine.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double cosine = std::pow(1 - u, 1.0 / 11), sine = std::sqrt(1 - cosine * cosine);
    const double angle = 2 * std::numbers::pi * v;
    return {{sine * std::cos(angle), sine * std::sin(angle), cosine}, cosine / std::numbers::pi};
}
