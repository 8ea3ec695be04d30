// hint: radius_squared
#include "raylab/sampling/mapping/lens_point.h"

#include <complex>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const auto point = std::polar(radius * radius * std::sqrt(v), 2 * std::numbers::pi * u);
    return {point.real(), point.imag()};
}
