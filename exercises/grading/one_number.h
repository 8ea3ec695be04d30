#pragma once

#include "case.h"
#include "words.h"

#include <cmath>

namespace raylab::grading {

/// The judgement of an answer that is one finite number and may be off by `most`.
inline Judgement judged_number(double expected, double given, double most) {
    Judgement result{.expected = words(expected), .got = words(given)};
    if (!std::isfinite(given))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (std::abs(given - expected) <= most)
        result.outcome = Judgement::Outcome::right;
    return result;
}

}  // namespace raylab::grading
