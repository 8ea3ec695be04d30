// hint: columns
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double x = 2 * u - 1;
    return {radius * x, radius * (2 * v - 1) * std::sqrt(1 - x * x)};
}
