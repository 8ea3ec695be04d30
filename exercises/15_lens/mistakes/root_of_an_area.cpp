// hint: radius_under_the_root
// Solves r^2 = radius v.
#include "raylab/sampling/mapping/lens_point.h"

#include <complex>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const auto point = std::sqrt(radius) * std::polar(std::sqrt(v), 2 * std::numbers::pi * u);
    return {point.real(), point.imag()};
}
