#include "judging.h"

#include "hinting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::grading {

namespace {

std::span<const double> answer_to(const Exercise& exercise, std::size_t index, std::span<const double> answers) {
    return answers.subspan(index * exercise.outputs, exercise.outputs);
}

GroupScore& score_of(std::vector<GroupScore>& groups, const Case& question) {
    const auto found = std::ranges::find_if(
        groups, [&](const auto& score) { return score.group == question.group && score.kind == question.kind; });
    if (found != groups.end()) return *found;
    return groups.emplace_back(GroupScore{question.group, question.kind});
}

// Whether two answers to a case are the same, bit for bit, but for different kinds of NaN.
bool is_same(std::span<const double> a, std::span<const double> b) {
    return std::ranges::equal(a, b, [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

Found order_found(const std::vector<Case>& cases, const std::vector<std::size_t>& by_order) {
    return {"depends_on_order",
            fmt::format("Asked from last to first, {} of {} cases have another answer; case {} ({}) is one.",
                        by_order.size(), cases.size(), by_order.front(), cases[by_order.front()].group),
            by_order.front()};
}

bool is_right(const Exercise& exercise, const std::vector<Case>& cases, const Answer& answer) {
    const auto answers = answers_of(exercise, answer, cases);
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (cases[i].kind == Case::Kind::graded &&
            exercise.judge(cases[i], answer_to(exercise, i, answers)).outcome != Judgement::Outcome::right)
            return false;
    return true;
}

// Whether two counts of a task's work are those of the same mistake, up to a quarter.
bool is_like(const WorkScore& a, const WorkScore& b) {
    if (a.yours.has_value() != b.yours.has_value() || a.passed() != b.passed()) return false;
    if ((a.strayed > 0) != (b.strayed > 0)) return false;
    return !a.yours || std::abs(*a.yours - *b.yours) <= 0.25 * *b.yours;
}

}  // namespace

std::vector<double> answers_of(const Exercise& exercise, const Answer& answer, const std::vector<Case>& cases) {
    std::vector<double> answers(cases.size() * exercise.outputs, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < cases.size(); ++i)
        answer(cases[i].input, std::span(answers).subspan(i * exercise.outputs, exercise.outputs));
    return answers;
}

Verdict judge(const Exercise& exercise, const std::vector<Case>& cases, std::span<const double> given,
              std::span<const double> again) {
    const auto complete = [&](std::span<const double> some) {
        std::vector<double> answers(some.begin(), some.end());
        answers.resize(cases.size() * exercise.outputs, std::numeric_limits<double>::quiet_NaN());
        return answers;
    };
    auto answers = complete(given);
    const auto second = complete(again.empty() ? given : again);
    Verdict verdict;
    Outcomes outcomes;
    std::vector<std::size_t> by_order;  // graded cases that were answered in two ways
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto answer = std::span(answers).subspan(i * exercise.outputs, exercise.outputs);
        const auto other = answer_to(exercise, i, second);
        const bool differs = !is_same(answer, other);
        auto judgement = exercise.judge(cases[i], answer);
        if (differs && judgement.outcome == Judgement::Outcome::right) {
            const std::vector<double> first(answer.begin(), answer.end());
            std::ranges::copy(other, answer.begin());
            judgement = exercise.judge(cases[i], answer);
            if (judgement.outcome == Judgement::Outcome::right && !agree(first, other)) {
                judgement.outcome = Judgement::Outcome::wrong;
                judgement.expected = "the same whenever it is asked: " + judgement.expected;
                judgement.got += ", and something else before";
            }
        }
        const bool right = judgement.outcome == Judgement::Outcome::right;
        auto& score = score_of(verdict.groups, cases[i]);
        ++score.total;
        score.right += right;
        if (cases[i].kind != Case::Kind::graded) continue;
        ++verdict.total;
        verdict.right += right;
        (right ? outcomes.right : outcomes.wrong).push_back(i);
        if (differs && !right) by_order.push_back(i);
        if (!right && !verdict.first_wrong)
            verdict.first_wrong = WrongCase{i,
                                            cases[i].group,
                                            exercise.story(cases[i]),
                                            judgement.expected,
                                            judgement.got,
                                            cases[i],
                                            {answer.begin(), answer.end()}};
    }
    std::ranges::stable_partition(verdict.groups, [](const auto& s) { return s.kind == Case::Kind::graded; });
    if (outcomes.wrong.empty()) return verdict;
    const auto found =
        by_order.empty() ? find_hint(exercise, cases, answers, outcomes) : std::optional(order_found(cases, by_order));
    if (!found) return verdict;
    verdict.hint = found->hint;
    verdict.evidence = found->evidence;
    return verdict;
}

Verdict with_work(Verdict verdict, const Exercise& exercise, const std::vector<Case>& cases,
                  std::vector<WorkScore> work) {
    verdict.work = std::move(work);
    if (verdict.passed() || !verdict.answers_right()) return verdict;
    for (const auto& [name, hint, answer] : exercise.mistakes) {
        if (!is_right(exercise, cases, answer)) continue;
        if (!std::ranges::equal(work_scores(exercise, answer), verdict.work, is_like)) continue;
        verdict.hint = hint;
        verdict.evidence = "Each answer is right, and the work is that of a typical mistake.";
        return verdict;
    }
    if (verdict.works_too_much()) {
        verdict.hint = "too_much_work";
        verdict.evidence = "Each answer is right, and every ray meets what it should.";
    }
    return verdict;
}

Verdict verdict_on(const Exercise& exercise, const std::vector<Case>& cases, const Answer& answer) {
    auto verdict = judge(exercise, cases, answers_of(exercise, answer, cases));
    if (exercise.work.empty() || !verdict.answers_right()) return verdict;
    return with_work(std::move(verdict), exercise, cases, work_scores(exercise, answer));
}

}  // namespace raylab::grading
