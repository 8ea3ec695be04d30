// hint: pdf_times_two
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto foot = std::polar(std::sqrt(v), 2 * std::numbers::pi * u);
    const double z = std::sqrt(1 - std::norm(foot));
    return {{foot.imag(), foot.real(), z}, z / (std::numbers::pi / 2)};
}
