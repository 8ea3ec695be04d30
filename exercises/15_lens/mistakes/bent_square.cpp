// hint: bent_square
// Shortens each coordinate of a square by the other one: it fills the lens, and crowds at four places of its rim.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double across = 2 * u - 1, up = 1 - 2 * v;
    const double x = across * std::sqrt(1 - up * up / 2), y = up * std::sqrt(1 - across * across / 2);
    return {radius * x, radius * y};
}
