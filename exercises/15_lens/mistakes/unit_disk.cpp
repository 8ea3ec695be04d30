// hint: radius_forgotten
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double a = 2 * u - 1, b = 2 * v - 1;
    if (a == 0 && b == 0) return {0, 0};
    if (std::abs(a) > std::abs(b)) {
        const double angle = std::numbers::pi / 4 * (b / a);
        return {a * std::cos(angle), a * std::sin(angle)};
    }
    const double angle = std::numbers::pi / 4 * (a / b);
    return {b * std::sin(angle), b * std::cos(angle)};
}
