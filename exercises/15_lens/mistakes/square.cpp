// hint: square
#include "raylab/sampling/mapping/lens_point.h"

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    return {radius * (2 * u - 1), radius * (2 * v - 1)};
}
