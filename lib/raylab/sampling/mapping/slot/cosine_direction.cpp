#include "raylab/sampling/mapping/cosine_direction.h"

#include "raylab/sampling/mapping/concentric_disk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// Points that are uniform on the disk, lifted onto the hemisphere above: a small area around a direction is seen from
// straight above smaller by the cosine (Malley).
raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const auto [x, y] = concentric_disk(u, v);
    const double cosine = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    return {{x, y, cosine}, cosine / std::numbers::pi};
}
