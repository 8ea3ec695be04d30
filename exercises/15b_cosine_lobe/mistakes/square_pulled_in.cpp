// hint: square_pulled_in
// Moves the points of a square that are outside of its circle onto the circle.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    double x = 2 * v - 1, y = 2 * u - 1;
    const double far = std::max(1.0, std::sqrt(x * x + y * y));
    x /= far;
    y /= far;
    const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    return {{x, y, z}, z / std::numbers::pi};
}
