#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace raylab::grading {

inline double log_choose(std::size_t all, std::size_t some) {
    const auto n = static_cast<double>(all), k = static_cast<double>(some);
    return std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
}

/// The chance that of `drawn` things out of `all`, of which `special` are special, `seen` or more are (hypergeometric).
inline double chance_of(std::size_t seen, std::size_t drawn, std::size_t special, std::size_t all) {
    const std::size_t plain = all - special, fewest = drawn - std::min(drawn, plain);
    double chance = 0;
    for (std::size_t k = std::max(seen, fewest); k <= std::min(drawn, special); ++k)
        chance += std::exp(log_choose(special, k) + log_choose(plain, drawn - k) - log_choose(all, drawn));
    return chance;
}

}  // namespace raylab::grading
