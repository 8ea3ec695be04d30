#include "asking.h"

#include <algorithm>
#include <limits>

namespace raylab::grading {

namespace {

// A hint, or a first wrong case, from answers that never came would be made up.
Verdict without_hint(Verdict verdict) {
    verdict.hint.reset();
    verdict.evidence.clear();
    return verdict;
}

Verdict verdict_on_part(const Exercise& exercise, const std::vector<Case>& cases, const Answers& answers) {
    auto verdict = without_hint(judge(exercise, cases, answers.values));
    if (verdict.first_wrong && verdict.first_wrong->index >= answers.values.size() / exercise.outputs)
        verdict.first_wrong.reset();
    return verdict;
}

// Of answers from the last case on; those that never came are no numbers.
std::vector<double> in_order_of_cases(const Exercise& exercise, const std::vector<Case>& cases,
                                      std::span<const double> last_ones) {
    std::vector<double> answers(cases.size() * exercise.outputs, std::numeric_limits<double>::quiet_NaN());
    auto place = answers.end();
    for (; !last_ones.empty(); last_ones = last_ones.subspan(exercise.outputs)) {
        place -= static_cast<std::ptrdiff_t>(exercise.outputs);
        std::ranges::copy(last_ones.first(exercise.outputs), place);
    }
    return answers;
}

JudgedAnswers with_work(JudgedAnswers asked, const Exercise& exercise, const Workplace& workplace) {
    auto worked = run_work(exercise, workplace, max_questions(exercise));
    if (worked.end == Answers::End::complete) {
        asked.answers.seconds += worked.seconds;
        asked.verdict =
            with_work(std::move(asked.verdict), exercise, asked.cases, work_scores(exercise, worked.values));
        return asked;
    }
    const bool only_work_fails = asked.verdict.answers_right();
    asked.verdict.work_ended = worked.reason;
    if (!only_work_fails) return asked;
    asked.ended = to_text(exercise, worked);
    asked.answers = std::move(worked);
    return asked;
}

}  // namespace

std::vector<double> inputs_of(const std::vector<Case>& cases) {
    std::vector<double> inputs;
    for (const auto& question : cases) inputs.insert(inputs.end(), question.input.begin(), question.input.end());
    return inputs;
}

JudgedAnswers ask(const Exercise& exercise, const Workplace& workplace, std::uint64_t seed) {
    JudgedAnswers asked{.cases = exercise.cases(seed), .answers = {}, .verdict = {}, .ended = {}};
    asked.answers = run(exercise, workplace, inputs_of(asked.cases));
    if (asked.answers.end != Answers::End::complete) {
        asked.ended = to_text(exercise, asked.answers, asked.cases);
        asked.verdict = verdict_on_part(exercise, asked.cases, asked.answers);
        return asked;
    }
    auto again = run_from_last(exercise, workplace, inputs_of(asked.cases));
    if (again.end != Answers::End::complete) {
        asked.ended = "asked the same cases from last to first, " +
                      to_text(exercise, again, {asked.cases.rbegin(), asked.cases.rend()});
        asked.verdict = without_hint(
            judge(exercise, asked.cases, asked.answers.values, in_order_of_cases(exercise, asked.cases, again.values)));
        asked.verdict.first_wrong.reset();
        asked.answers = std::move(again);
        return asked;
    }
    asked.answers.seconds += again.seconds;
    asked.verdict = judge(exercise, asked.cases, asked.answers.values, again.values);
    return exercise.work.empty() ? asked : with_work(std::move(asked), exercise, workplace);
}

}  // namespace raylab::grading
