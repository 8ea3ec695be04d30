// hint: half_turn
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto foot = std::polar(std::sqrt(1 - v), std::numbers::pi / 2 * u);
    const double z = std::sqrt(v);
    return {{foot.real(), foot.imag(), z}, z / std::numbers::pi};
}
