// hint: pi_by_hand
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double r = radius * std::sqrt(u), angle = 2 * 3.14 * v;
    return {r * std::cos(angle), r * std::sin(angle)};
}
