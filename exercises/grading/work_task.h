#pragma once

#include "raylab/geometry/ray.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Counted work: rays traverse a structure that calls the function under test repeatedly to find where to go on.

namespace raylab::grading {

/// A function that answers cases.
using Answer = std::function<void(std::span<const double> input, std::span<double> output)>;

/// The results of all of a task's rays.
struct Worked {
    double work = 0;                             // in the task's unit
    std::vector<std::optional<Primitive>> hits;  // for each ray its first hit
};

struct WorkTask {
    std::string rays;  // "rays from a corner"
    std::string unit;  // "cells a ray"
    std::function<Worked(const Answer&)> trace;
};

/// Thrown by an answer that is refused: the caller has to stop.
struct NoAnswer {};

/// Traces a task with a function that is called at most this often; absent where it would have been called once more,
/// or gave no answer.
inline std::optional<Worked> traced(const WorkTask& task, std::size_t largest, const Answer& answer) {
    std::size_t asked = 0;
    try {
        return task.trace([&](std::span<const double> input, std::span<double> output) {
            if (++asked > largest) throw NoAnswer{};
            // Values that the function does not set are NaN, so that no value of the last case can count as right.
            std::ranges::fill(output, std::numeric_limits<double>::quiet_NaN());
            answer(input, output);
        });
    } catch (const NoAnswer&) {
        return std::nullopt;
    }
}

}  // namespace raylab::grading
