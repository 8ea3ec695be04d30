// hint: one_wedge
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double x = 2 * u - 1, y = 2 * v - 1;
    if (x == 0) return {0, 0};
    const double angle = std::numbers::pi / 4 * (y / x);
    return {radius * x * std::cos(angle), radius * x * std::sin(angle)};
}
