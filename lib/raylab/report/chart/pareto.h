#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace raylab {

/// What something costs in two ways, less being better in both.
struct Tradeoff {
    double error, time;
};

/// The indices of those that nothing beats: by rising error, then rising time. None is both at least as good and
/// somewhere better. Points with a NaN are never among them.
std::vector<std::size_t> pareto_front(std::span<const Tradeoff> points);

}  // namespace raylab
