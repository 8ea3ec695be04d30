// hint: nothing_at_the_centre
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double a = 2 * u - 1, b = 2 * v - 1, quarter = std::numbers::pi / 4;
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b, angle = wide ? quarter * (b / a) : 2 * quarter - quarter * (a / b);
    return {radius * r * std::cos(angle), radius * r * std::sin(angle)};
}
