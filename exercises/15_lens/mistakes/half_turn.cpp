// hint: part_of_a_turn
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * std::sqrt(u), angle = std::numbers::pi * v;
    return {r * std::cos(angle), r * std::sin(angle)};
}
