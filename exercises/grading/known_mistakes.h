#pragma once

#include "symptom_search.h"

namespace raylab::grading {

/// The known mistake that explains wrong answers best: it gives exactly the student's answer in most of the cases that
/// the student got wrong, and is wrong in as few others as possible. Absent where none explains more than this share.
std::optional<Found> find_known_mistake(const Exercise& exercise, const std::vector<Case>& cases,
                                        std::span<const double> answers, const Outcomes& outcomes, double least);

}  // namespace raylab::grading
