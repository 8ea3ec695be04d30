// hint: uneven_turn
// The root is taken of the number of the angle, too.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * std::sqrt(u), angle = 2 * std::numbers::pi * std::sqrt(v);
    return {r * std::cos(angle), r * std::sin(angle)};
}
