#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <complex>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    // Malley's method: a point of the disk, as a complex number, lifted to the hemisphere. The root of v is what is
    // missing to the length 1.
    const auto foot = std::polar(std::sqrt(1 - v), 2 * std::numbers::pi * u);
    const double z = std::sqrt(v);
    return {{foot.imag(), foot.real(), z}, z / std::numbers::pi};
}
