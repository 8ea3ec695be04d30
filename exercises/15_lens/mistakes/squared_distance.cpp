// hint: crowd_at_the_centre
// Takes a square where a root belongs.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * u * u, angle = 2 * std::numbers::pi * v;
    return {r * std::cos(angle), r * std::sin(angle)};
}
