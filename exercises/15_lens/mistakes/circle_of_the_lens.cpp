// hint: rim
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double angle = std::numbers::pi * (2 * u - 1);
    return {radius * std::sin(angle), radius * std::cos(angle)};
}
