// hint: diameter
// Takes what is given for half of the radius.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double a = 2 * u - 1, b = 2 * v - 1;
    if (a == 0 && b == 0) return {0, 0};
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b, quarter = std::numbers::pi / 4;
    const double angle = wide ? quarter * b / a : 2 * quarter - quarter * a / b;
    return {2 * radius * r * std::cos(angle), 2 * radius * r * std::sin(angle)};
}
