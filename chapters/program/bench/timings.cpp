#include "timings.h"

#include "raylab/experiment/measure/quantile.h"

#include <algorithm>
#include <limits>

namespace raylab::bench {

double Timings::typical() const {
    double speeds = 0;
    for (const auto& [processor, seconds] : seconds_) speeds += 1 / median(seconds);
    return static_cast<double>(seconds_.size()) / speeds;
}

double Timings::shortest() const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [processor, seconds] : seconds_) least = std::min(least, std::ranges::min(seconds));
    return least;
}

double Timings::longest() const {
    double most = 0;
    for (const auto& [processor, seconds] : seconds_) most = std::max(most, std::ranges::max(seconds));
    return most;
}

}  // namespace raylab::bench
