#pragma once

#include "raylab/experiment/measure/measure.h"

#include <cstddef>
#include <span>
#include <vector>

namespace raylab {

/// Two costs of something; less is better in both.
struct Tradeoff {
    double error;
    Spread time;
};

/// The indices of the Pareto front, by rising error, then rising time: of those that no other beats. One beats another
/// if it is faster and errs no more, or errs less and is not slower. Times whose quartiles overlap are a tie: neither
/// is faster. Points with a NaN are never on the front.
std::vector<std::size_t> pareto_front(std::span<const Tradeoff> points);

}  // namespace raylab
