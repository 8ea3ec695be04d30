#pragma once

#include "exercise.h"

#include <optional>
#include <span>

namespace raylab::grading {

/// What wrong answers have in common, with the evidence for it.
struct Found {
    std::string hint;
    std::string evidence;   // sentences: in how many wrong answers it is seen, and in how many cases it could be
    std::size_t shown = 0;  // a case that shows it
};

/// The graded cases, by their index, and which of them were answered wrongly.
struct Outcomes {
    std::vector<std::size_t> wrong, right;
};

/// The first of the symptoms that nearly all wrong answers show, and that shows wherever it must. Absent where the
/// evidence supports none.
std::optional<Found> find_symptom(const Exercise& exercise, std::span<const Symptom> symptoms,
                                  const std::vector<Case>& cases, std::span<const double> answers,
                                  const Outcomes& outcomes);

/// The same of the first group alone that has wrong answers, all of which must show it: of two mistakes, one.
std::optional<Found> find_symptom_of_first_group(const Exercise& exercise, const std::vector<Case>& cases,
                                                 std::span<const double> answers, const Outcomes& outcomes);

}  // namespace raylab::grading
