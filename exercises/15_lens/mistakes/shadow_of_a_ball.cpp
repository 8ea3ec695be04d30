// hint: crowd_at_the_rim
// Points of a hemisphere, seen from above.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double z = u, r = radius * std::sqrt(1 - z * z), angle = 2 * std::numbers::pi * v;
    return {r * std::cos(angle), r * std::sin(angle)};
}
