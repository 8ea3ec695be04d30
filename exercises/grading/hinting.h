#pragma once

#include "symptom_search.h"

namespace raylab::grading {

/// The hint for wrong answers that the evidence supports; absent where it supports none. First comes a known mistake
/// whose numbers these are nearly throughout, then what wrong answers have in common (of this exercise, in the order of
/// its list), then that all answers are the same, then a known mistake whose numbers most of them are, then what those
/// of the first wrong group have in common, then what wrong answers to any exercise may have, then that the first one
/// is no number, last that all of them are of one group.
std::optional<Found> find_hint(const Exercise& exercise, const std::vector<Case>& cases,
                               std::span<const double> answers, const Outcomes& outcomes);

}  // namespace raylab::grading
