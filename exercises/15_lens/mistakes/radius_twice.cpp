// hint: radius_squared
// Stretches the root and then the point.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * std::sqrt(u), angle = 2 * std::numbers::pi * v;
    return {radius * r * std::cos(angle), radius * r * std::sin(angle)};
}
