// hint: crowd_at_the_centre
// A distance between the even one and its root.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * (u + std::sqrt(u)) / 2, angle = 2 * std::numbers::pi * v;
    return {r * std::sin(angle), r * std::cos(angle)};
}
