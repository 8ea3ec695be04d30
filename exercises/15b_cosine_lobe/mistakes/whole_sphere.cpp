// hint: below_the_surface
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double cosine = 1 - 2 * u, sine = std::sqrt(1 - cosine * cosine), angle = 2 * std::numbers::pi * v;
    return {{sine * std::cos(angle), sine * std::sin(angle), cosine}, std::abs(cosine) / std::numbers::pi};
}
