// hint: pi_by_hand
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double pi = 3.14, sine = std::sqrt(u), cosine = std::sqrt(1 - u), angle = 2 * pi * v;
    return {{sine * std::cos(angle), sine * std::sin(angle), cosine}, cosine / std::acos(-1)};
}
