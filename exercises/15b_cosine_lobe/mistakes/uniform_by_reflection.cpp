// hint: uniform_and_says_so
// Points of the sphere, those below reflected upward.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double z = 2 * v - 1, r = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * u;
    return {{r * std::sin(phi), r * std::cos(phi), std::abs(z)}, 0.5 * std::numbers::inv_pi};
}
