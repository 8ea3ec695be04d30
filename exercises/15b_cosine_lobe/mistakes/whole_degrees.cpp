// hint: whole_steps
// The turn is an int, in degrees: no direction lies between two of them.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const int degrees = static_cast<int>(v * 360);
    const double turn = degrees * std::numbers::pi / 180, z = std::sqrt(1 - u);
    return {{std::sqrt(u) * std::cos(turn), std::sqrt(u) * std::sin(turn), z}, z / std::numbers::pi};
}
