// hint: y_is_up
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double theta = std::asin(std::sqrt(v)), phi = 2 * std::numbers::pi * u;
    return {{std::cos(theta), std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi)},
            std::cos(theta) / std::numbers::pi};
}
