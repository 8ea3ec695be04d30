// hint: square_pulled_in
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double x = 2 * u - 1, y = 2 * v - 1, length = std::hypot(x, y);
    const double r = length > 1 ? radius / length : radius;
    return {r * x, r * y};
}
