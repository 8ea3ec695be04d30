// hint: ellipse
// The radius stands under the root of one coordinate, and before the root of the other.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double turn = 2 * std::numbers::pi * u;
    const double x = radius * std::sqrt(v) * std::sin(turn);
    const double y = std::sqrt(radius / 2 * v) * std::cos(turn);
    return {x, y};
}
