// hint: reciprocal
// The area of the disk over the cosine: so many steradians stand for one direction, and the density is one over that.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto foot = std::polar(std::sqrt(v), 2 * std::numbers::pi * u);
    const double z = std::sqrt(1 - v), steradians = std::numbers::pi / z;
    return {{foot.real(), foot.imag(), z}, steradians};
}
