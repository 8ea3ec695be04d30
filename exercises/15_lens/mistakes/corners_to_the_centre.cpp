// hint: square_pulled_in
// Points outside of the lens are put into its centre.
#include "raylab/sampling/mapping/lens_point.h"

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double x = radius * (1 - 2 * v), y = radius * (2 * u - 1);
    if (x * x + y * y > radius * radius) return {0, 0};
    return {x, y};
}
