// hint: pdf_without_cosine
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double theta = std::asin(std::sqrt(v)), phi = 2 * std::numbers::pi * u;
    const double area = std::numbers::pi;  // of the disk below
    return {{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}, 1 / area};
}
