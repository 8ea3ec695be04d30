#include "hinting.h"

#include "general_symptoms.h"
#include "known_mistakes.h"

namespace raylab::grading {

namespace {

// By how much a known mistake must explain the wrong answers to count: throughout, or more than nothing else would.
constexpr double throughout = 0.99, mostly = 0.8;

}  // namespace

std::optional<Found> find_hint(const Exercise& exercise, const std::vector<Case>& cases,
                               std::span<const double> answers, const Outcomes& outcomes) {
    if (auto found = find_known_mistake(exercise, cases, answers, outcomes, throughout)) return found;
    if (auto found = find_symptom(exercise, exercise.symptoms, cases, answers, outcomes)) return found;
    if (auto found = find_constant_answer(exercise, answers, outcomes)) return found;
    if (auto found = find_known_mistake(exercise, cases, answers, outcomes, mostly)) return found;
    if (auto found = find_symptom_of_first_group(exercise, cases, answers, outcomes)) return found;
    if (auto found = find_symptom(exercise, general_symptoms(exercise), cases, answers, outcomes)) return found;
    if (auto found = find_first_is_no_number(exercise, cases, answers, outcomes)) return found;
    return find_single_group(cases, outcomes);
}

}  // namespace raylab::grading
