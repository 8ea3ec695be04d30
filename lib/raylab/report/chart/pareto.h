#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace raylab {

/// Two costs of something; less is better in both.
struct Tradeoff {
    double error, time;
};

/// The indices of the Pareto front, by rising error, then rising time: of those for which no other is at least as good
/// in both and better in one. Points with a NaN are never among them.
std::vector<std::size_t> pareto_front(std::span<const Tradeoff> points);

}  // namespace raylab
