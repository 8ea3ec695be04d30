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

// Counted work: rays on their way through a structure that asks the function under test, again and again, where to go
// on.

namespace raylab::grading {

/// Something that answers cases.
using Answer = std::function<void(std::span<const double> input, std::span<double> output)>;

/// What became of a task's rays, all together.
struct Worked {
    double work = 0;                             // in the task's unit
    std::vector<std::optional<Primitive>> hits;  // of each ray: what it meets first
};

struct WorkTask {
    std::string rays;  // "rays from a corner"
    std::string unit;  // "cells a ray"
    std::function<Worked(const Answer&)> trace;
};

/// Thrown by an answer that will not be given: whoever asks has to stop.
struct NoAnswer {};

/// Traces a task with a function that is asked at most so often; absent: it would have been asked once more, or gave no
/// answer.
inline std::optional<Worked> traced(const WorkTask& task, std::size_t most, const Answer& answer) {
    std::size_t asked = 0;
    try {
        return task.trace([&](std::span<const double> input, std::span<double> output) {
            if (++asked > most) throw NoAnswer{};
            // What the function does not set is not a number, so nothing left over from the last case can be right.
            std::ranges::fill(output, std::numeric_limits<double>::quiet_NaN());
            answer(input, output);
        });
    } catch (const NoAnswer&) {
        return std::nullopt;
    }
}

}  // namespace raylab::grading
