// hint: columns
// Chooses a height, and then a place in its row.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double y = radius * (2 * u - 1), half = std::sqrt(radius * radius - y * y);
    return {-half + 2 * half * v, y};
}
