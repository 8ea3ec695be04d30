// hint: crowd_at_the_rim
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * std::sqrt(std::sqrt(v)), angle = 2 * std::numbers::pi * u;
    return {r * std::cos(angle), r * std::sin(angle)};
}
