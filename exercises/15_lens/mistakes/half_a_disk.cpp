// hint: part_of_a_turn
// An arc cosine goes from 0 to pi.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * std::sqrt(v), angle = std::acos(1 - 2 * u);
    return {r * std::cos(angle), r * std::sin(angle)};
}
