// hint: part_of_a_turn
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * std::sqrt(u);
    return {r * std::cos(v), r * std::sin(v)};
}
