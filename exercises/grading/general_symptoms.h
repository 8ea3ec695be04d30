#pragma once

#include "symptom_search.h"

namespace raylab::grading {

/// What wrong answers to any exercise may have in common, by the parts of its answers: no numbers, a constant factor, a
/// turned sign, exchanged axes, off by one, none where there is one. Their hints stand in exercises/hints.toml.
std::vector<Symptom> general_symptoms(const Exercise& exercise);

/// Every answer is the same, whatever was asked.
std::optional<Found> find_constant_answer(const Exercise& exercise, std::span<const double> answers,
                                          const Outcomes& outcomes);

/// Where the first wrong answer, which is shown, is not a number: its hint, though most of the others are numbers.
std::optional<Found> find_first_is_no_number(const Exercise& exercise, const std::vector<Case>& cases,
                                             std::span<const double> answers, const Outcomes& outcomes);

/// All wrong answers are to one group of cases, and some of the right ones are to others.
std::optional<Found> find_single_group(const std::vector<Case>& cases, const Outcomes& outcomes);

}  // namespace raylab::grading
