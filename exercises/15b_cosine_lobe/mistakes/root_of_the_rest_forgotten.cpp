// hint: pdf_squared
// What is missing to the length 1 is z squared. The root is taken for the direction, and not for the density.
#include "raylab/sampling/mapping/cosine_direction.h"

#include "raylab/sampling/mapping/concentric_disk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto [x, y] = concentric_disk(u, v);
    const double rest = std::max(0.0, 1 - x * x - y * y);
    return {{x, y, std::sqrt(rest)}, rest * std::numbers::inv_pi};
}
