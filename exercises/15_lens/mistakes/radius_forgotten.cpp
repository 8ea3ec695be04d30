// hint: radius_forgotten
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = std::sqrt(u), angle = 2 * std::numbers::pi * v;
    return {r * std::cos(angle), r * std::sin(angle)};
}
