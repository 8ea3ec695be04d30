#pragma once

#include "arguments.h"
#include "case.h"
#include "spread.h"

#include <span>
#include <vector>

// A case of the lens, and its points as shares of the lens.

namespace raylab::grading::lens {

struct LensCase {
    double radius;
    double which;  // the numbers, as number_pairs.h names them
};

inline LensCase lens_case(const Case& question) { return {question.input[0], question.input[1]}; }

/// Where each point lies, by the share of the area of a lens of this radius that is nearer to the centre.
inline std::vector<DrawnShare> lens_shares(std::span<const double> answer, double radius) {
    std::vector<DrawnShare> all;
    for (std::size_t i = 0; i < pairs; ++i) {
        const double x = answer[2 * i] / radius, y = answer[2 * i + 1] / radius;
        all.push_back({x * x + y * y, turn_share(x, y)});
    }
    return all;
}

}  // namespace raylab::grading::lens
