// hint: uneven_turn
// The direction of a point of the square: its corners are seen more often.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double x = 2 * u - 1, y = 2 * v - 1, larger = std::fmax(std::abs(x), std::abs(y));
    if (larger == 0) return {0, 0};
    const double scale = radius * larger / std::hypot(x, y);
    return {scale * x, scale * y};
}
