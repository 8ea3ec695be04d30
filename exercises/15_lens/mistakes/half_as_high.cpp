// hint: ellipse
// One coordinate is halved.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double distance = radius * std::sqrt(u), angle = 2 * std::numbers::pi * v;
    return {distance * std::cos(angle), distance * std::sin(angle) / 2};
}
