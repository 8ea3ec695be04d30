// hint: part_of_a_turn
// Finds the second side of the right triangle by Pythagoras: a root is never negative, so there is no lower half.
#include "raylab/sampling/mapping/lens_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double squared = radius * radius * v;
    const double x = std::sqrt(squared) * std::cos(2 * std::numbers::pi * u);
    return {x, std::sqrt(std::max(0.0, squared - x * x))};
}
