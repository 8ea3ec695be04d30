// hint: whole_steps
// The angle is rounded to whole degrees before it becomes one in radians: all points lie on 360 rays.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double degree = std::floor(360 * u), turn = std::numbers::pi / 180 * degree, r = radius * std::sqrt(v);
    return {r * std::sin(turn), r * std::cos(turn)};
}
