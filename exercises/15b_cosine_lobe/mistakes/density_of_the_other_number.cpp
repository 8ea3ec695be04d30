// hint: pdf_by_the_sine
// The root of u is the sine here.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto foot = std::polar(std::sqrt(1 - u), 2 * std::numbers::pi * v);
    return {{foot.real(), foot.imag(), std::sqrt(u)}, std::sqrt(1 - u) * std::numbers::inv_pi};
}
