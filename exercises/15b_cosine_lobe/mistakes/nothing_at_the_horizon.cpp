// hint: nothing_at_the_horizon
#include "raylab/sampling/mapping/cosine_direction.h"

#include "raylab/sampling/mapping/concentric_disk.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto [x, y] = concentric_disk(u, v);
    const double cosine = std::sqrt(1 - x * x - y * y);
    return {{x, y, cosine}, cosine / std::numbers::pi};
}
