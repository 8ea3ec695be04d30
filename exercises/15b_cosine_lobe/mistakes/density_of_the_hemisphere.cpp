// hint: pdf_of_uniform
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto foot = std::polar(std::sqrt(1 - v), 2 * std::numbers::pi * u);
    const double steradians = 2 * std::numbers::pi;
    return {{foot.imag(), foot.real(), std::sqrt(v)}, 1 / steradians};
}
