// hint: sqrt_forgotten
#include "raylab/sampling/mapping/lens_point.h"

#include <complex>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const auto point = std::polar((1 - v) * radius, std::numbers::pi * (2 * u - 1));
    return {point.real(), point.imag()};
}
