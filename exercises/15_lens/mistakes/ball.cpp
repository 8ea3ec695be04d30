// hint: cube_root
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = std::pow(v, 1.0 / 3) * radius, angle = -2 * std::numbers::pi * u;
    return {r * std::sin(angle), r * std::cos(angle)};
}
