#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * std::sqrt(1 - v), angle = std::numbers::pi * (1 - 2 * u);
    return {r * std::sin(angle), r * std::cos(angle)};
}
