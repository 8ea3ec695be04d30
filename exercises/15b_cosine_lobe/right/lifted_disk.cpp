#include "raylab/sampling/mapping/cosine_direction.h"

#include "raylab/sampling/mapping/concentric_disk.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto [x, y] = concentric_disk(v, u);
    const double squared = x * x + y * y;
    const double z = squared < 1 ? std::sqrt(1 - squared) : 0;
    return {{x, y, z}, z * std::numbers::inv_pi};
}
