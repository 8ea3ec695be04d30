// hint: same_number_twice
#include "raylab/sampling/mapping/lens_point.h"

#include <complex>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const auto point = std::polar(radius * std::sqrt(v), 8 * std::numbers::pi * v);
    return {point.real(), point.imag()};
}
