// hint: uneven_turn
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double sine = std::sqrt(u), cosine = std::sqrt(1 - u), angle = 2 * std::numbers::pi * std::sqrt(v);
    return {{sine * std::cos(angle), sine * std::sin(angle), cosine}, cosine / std::numbers::pi};
}
