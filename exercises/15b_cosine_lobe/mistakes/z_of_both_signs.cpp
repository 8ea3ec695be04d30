// hint: below_the_surface
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double sine = std::sqrt(v), angle = 2 * std::numbers::pi * u;
    const double cosine = (u < 0.5 ? 1 : -1) * std::sqrt(1 - v);
    return {{sine * std::cos(angle), sine * std::sin(angle), cosine}, std::abs(cosine) / std::numbers::pi};
}
