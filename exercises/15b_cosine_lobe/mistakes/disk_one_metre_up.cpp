// hint: lifted_to_one
// or: not_unit
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto foot = std::polar(std::sqrt(v), 2 * std::numbers::pi * u);
    return {{foot.real(), foot.imag(), 1}, std::sqrt(1 - v) / std::numbers::pi};
}
