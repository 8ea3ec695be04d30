// hint: crowd_at_the_rim
// A scale that is too large, and what is beyond the rim comes to lie on it.
#include "raylab/sampling/mapping/lens_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double distance = std::min(1.0, 1.4 * std::sqrt(u)) * radius, angle = 2 * std::numbers::pi * v;
    return {distance * std::cos(angle), distance * std::sin(angle)};
}
