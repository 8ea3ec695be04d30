// hint: same_number_twice
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto foot = std::polar(std::sqrt(v), 6 * std::numbers::pi * v);
    const double z = std::sqrt(1 - v);
    return {{foot.real(), foot.imag(), z}, z / std::numbers::pi};
}
