// hint: square
#include "raylab/sampling/mapping/lens_point.h"

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double left = -radius, below = -radius, side = 2 * radius;
    return {left + side * v, below + side * u};
}
