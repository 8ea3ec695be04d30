// hint: one_wedge
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double a = 2 * u - 1, b = 2 * v - 1;
    const double angle = b != 0 ? std::numbers::pi / 2 - std::numbers::pi / 4 * (a / b) : 0;
    return {radius * b * std::cos(angle), radius * b * std::sin(angle)};
}
