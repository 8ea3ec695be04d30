// hint: radius_halved
#include "raylab/sampling/mapping/lens_point.h"

#include <complex>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double diameter = radius;
    const auto point = std::polar(diameter / 2 * std::sqrt(1 - v), 2 * std::numbers::pi * u);
    return {point.imag(), point.real()};
}
