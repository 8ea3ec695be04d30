#pragma once

#include "arguments.h"
#include "case.h"
#include "spread.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

// The directions of an answer, what density each should have, and where it lies.

namespace raylab::grading::cosine_lobe {

inline bool is_finite(const SampledDirection& sampled) {
    return std::isfinite(dot(sampled.direction, sampled.direction)) && std::isfinite(sampled.pdf);
}

inline double right_density(const SampledDirection& sampled) {
    return std::max(0.0, sampled.direction.z) / std::numbers::pi;
}

/// Of all directions, the share with a smaller angle is the squared sine: the area below them on the ground.
inline DrawnShare lobe_share(const SampledDirection& sampled) {
    const Vec3d& d = sampled.direction;
    return {d.x * d.x + d.y * d.y, turn_share(d.x, d.y)};
}

inline std::vector<DrawnShare> lobe_shares(std::span<const double> answer) {
    std::vector<DrawnShare> all;
    for (std::size_t i = 0; i < pairs; ++i) all.push_back(lobe_share(sampled(answer, i)));
    return all;
}

}  // namespace raylab::grading::cosine_lobe
