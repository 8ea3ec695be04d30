// hint: nothing_at_the_horizon
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    // The lens' other map, of wedges; at the rim the sum of squares is rounded to more than 1.
    const double a = 2 * v - 1, b = 2 * u - 1, quarter = std::numbers::pi / 4;
    if (a == 0 && b == 0) return {{0, 0, 1}, std::numbers::inv_pi};
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b, angle = wide ? quarter * (b / a) : 2 * quarter - quarter * (a / b);
    const double x = r * std::cos(angle), y = r * std::sin(angle), z = std::sqrt(1 - x * x - y * y);
    return {{x, y, z}, z / std::numbers::pi};
}
