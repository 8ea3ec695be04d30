// hint: not_independent
// Makes the distance of the sum of both numbers, folded at 1, which is even by itself; and the direction of one of
// them.
#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const double sum = u + v, share = sum > 1 ? 2 - sum : sum;
    const double angle = 2 * std::numbers::pi * v;
    return {radius * share * std::cos(angle), radius * share * std::sin(angle)};
}
