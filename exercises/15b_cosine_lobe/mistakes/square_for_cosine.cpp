// hint: pdf_squared
// The share of the disk outside of the point is taken for the cosine; it is the cosine's square.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double turn = 2 * std::numbers::pi * u, out = std::sqrt(v), up = 1 - v;
    return {{out * std::sin(turn), out * std::cos(turn), std::sqrt(up)}, up / std::numbers::pi};
}
