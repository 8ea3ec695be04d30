#include "mistake_codes.h"

#include "judging.h"
#include "known_mistakes.h"

#include <algorithm>

namespace raylab::grading {

namespace {

Outcomes outcomes_of(const Exercise& exercise, const std::vector<Case>& cases, std::span<const double> answers) {
    Outcomes outcomes;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (cases[i].kind != Case::Kind::graded) continue;
        const auto answer = answers.subspan(i * exercise.outputs, exercise.outputs);
        const bool right = exercise.judge(cases[i], answer).outcome == Judgement::Outcome::right;
        (right ? outcomes.right : outcomes.wrong).push_back(i);
    }
    return outcomes;
}

}  // namespace

std::vector<Codes> mistakes_of(const Exercise& exercise) {
    const auto cases = exercise.cases(1);
    Exercise known = exercise;  // with the codes of one mistake alone
    std::vector<Codes> mistakes;
    for (const auto& code : exercise.mistakes) {
        const auto answers = answers_of(exercise, code.answer, cases);
        const auto outcomes = outcomes_of(exercise, cases, answers);
        const auto is_the_same = [&](const Codes& codes) {
            const auto& first = codes.front();
            if (first.hint != code.hint) return false;
            if (outcomes.wrong.empty())
                return outcomes_of(exercise, cases, answers_of(exercise, first.answer, cases)).wrong.empty();
            known.mistakes = codes;
            return find_known_mistake(known, cases, answers, outcomes, 0.75).has_value();
        };
        const auto found = std::ranges::find_if(mistakes, is_the_same);
        if (found == mistakes.end())
            mistakes.push_back({code});
        else
            found->push_back(code);
    }
    return mistakes;
}

}  // namespace raylab::grading
