// hint: pi_by_hand
#include "raylab/sampling/mapping/lens_point.h"

#include <complex>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double pi = 22.0 / 7;
    const auto point = std::polar(radius * std::sqrt(v), pi * (2 * u - 1));
    return {point.real(), point.imag()};
}
