#include "catch.h"

#include "judging.h"
#include "known_mistakes.h"
#include "rotating.h"
#include "sanitized.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

// A hint that is found only for the code it was made with is worth little. So typical mistakes are recorded twice, in
// two codes that have nothing in common but the mistake. That they do have it in common, their numbers show.

using namespace raylab::grading;

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

// A mistake, in each code in which it is recorded.
using Codes = std::vector<KnownAnswer>;

// Two codes are of one mistake if their hint is the same, and three of four wrong answers of the one are the other's.
// (Codes that answer all rightly, and work too much, have the same mistake if they have the same hint.)
std::vector<Codes> mistakes_of(const Exercise& exercise) {
    const auto cases = exercise.cases(1);
    std::vector<Codes> mistakes;
    for (const auto& code : exercise.mistakes) {
        const auto answers = answers_of(exercise, code.answer, cases);
        const auto outcomes = outcomes_of(exercise, cases, answers);
        const auto is_the_same = [&](const Codes& codes) {
            const auto& first = codes.front();
            if (first.hint != code.hint) return false;
            if (outcomes.wrong.empty())
                return outcomes_of(exercise, cases, answers_of(exercise, first.answer, cases)).wrong.empty();
            Exercise known = exercise;
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

std::string names(const Codes& codes) {
    std::string names = fmt::format("  {}:", codes.front().hint);
    for (const auto& code : codes) names += " " + code.name;
    return names + "\n";
}

}  // namespace

TEST_CASE("fifteen typical mistakes and more are recorded in two codes each") {
    if (is_sanitized) return;  // known_answers.cpp runs the same judge and mistakes
    for (std::size_t i = 0; i < exercises().size(); ++i) {
        const auto& exercise = exercises()[i];
        if (!is_tested_now(i, 4)) continue;
        std::size_t twice = 0;
        std::string all;
        for (const auto& codes : mistakes_of(exercise)) {
            twice += codes.size() >= 2;
            all += names(codes);
        }
        INFO(exercise.folder << ": " << twice << " in two codes or more:\n" << all);
        CHECK(twice >= 15);
    }
}
