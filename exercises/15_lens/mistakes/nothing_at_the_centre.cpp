// hint: nothing_at_the_centre
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double x = 2 * u - 1, y = 2 * v - 1;
    if (std::abs(x) > std::abs(y)) {
        const double angle = std::numbers::pi / 4 * (y / x);
        return {radius * x * std::cos(angle), radius * x * std::sin(angle)};
    }
    const double angle = std::numbers::pi / 4 * (x / y);
    return {radius * y * std::sin(angle), radius * y * std::cos(angle)};
}
