#include "judging.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::grading {

namespace {

std::span<const double> answer_to(const Exercise& exercise, std::size_t index, std::span<const double> answers) {
    return answers.subspan(index * exercise.outputs, exercise.outputs);
}

// What of the answer to each case tells mistakes apart. Numbers count as the same mistake's if they agree to far more
// digits than a judge's tolerance, and symptoms if they agree up to their noise.
std::vector<std::vector<double>> symptoms_of(const Exercise& exercise, const std::vector<Case>& cases,
                                             std::span<const double> answers) {
    std::vector<std::vector<double>> all;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto answer = answer_to(exercise, i, answers);
        all.push_back(exercise.symptoms ? exercise.symptoms(cases[i], answer)
                                        : std::vector(answer.begin(), answer.end()));
    }
    return all;
}

bool same_symptoms(std::span<const double> a, std::span<const double> b, double noise) {
    return std::ranges::equal(a, b, [noise](double x, double y) {
        if (std::isnan(x) || std::isnan(y)) return std::isnan(x) && std::isnan(y);
        if (std::isinf(x) || std::isinf(y)) return x == y;
        return std::abs(x - y) <= noise * std::max({1.0, std::abs(x), std::abs(y)});
    });
}

GroupScore& score_of(std::vector<GroupScore>& groups, const Case& question) {
    const auto found = std::ranges::find_if(
        groups, [&](const auto& score) { return score.group == question.group && score.kind == question.kind; });
    if (found != groups.end()) return *found;
    return groups.emplace_back(GroupScore{question.group, question.kind});
}

// How well a known mistake explains the graded answers.
struct Likeness {
    std::size_t wrong = 0;      // number of the student's wrong answers
    std::size_t explained = 0;  // number of those that equal the mistake's answer
    std::size_t excess = 0;     // number of cases in which the mistake is wrong and the student is right

    // The excess distinguishes a special mistake from a general one that happens to share its wrong answers.
    double score() const {
        const double all = static_cast<double>(std::max<std::size_t>(wrong, 1));
        return (static_cast<double>(explained) - 0.5 * static_cast<double>(excess)) / all;
    }
};

// A set of answers, and what tells its mistakes.
struct Told {
    std::span<const double> answers;
    std::vector<std::vector<double>> symptoms;
};

Likeness likeness(const Exercise& exercise, const std::vector<Case>& cases, const Told& yours,
                  const std::vector<bool>& right, const Told& mistaken) {
    Likeness result;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (cases[i].kind != Case::Kind::graded) continue;
        const bool same = same_symptoms(yours.symptoms[i], mistaken.symptoms[i], exercise.symptom_noise);
        result.wrong += !right[i];
        result.explained += !right[i] && same;
        // Judging may be slow (it may call the oracle), so it is done only where the two differ: nowhere else can the
        // mistake be wrong and the student right.
        if (right[i] && !same)
            result.excess +=
                exercise.judge(cases[i], answer_to(exercise, i, mistaken.answers)).outcome != Judgement::Outcome::right;
    }
    return result;
}

bool is_right(const Exercise& exercise, const std::vector<Case>& cases, const Answer& answer) {
    const auto answers = answers_of(exercise, answer, cases);
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (cases[i].kind == Case::Kind::graded &&
            exercise.judge(cases[i], answer_to(exercise, i, answers)).outcome != Judgement::Outcome::right)
            return false;
    return true;
}

}  // namespace

std::vector<double> answers_of(const Exercise& exercise, const Answer& answer, const std::vector<Case>& cases) {
    std::vector<double> answers(cases.size() * exercise.outputs, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < cases.size(); ++i)
        answer(cases[i].input, std::span(answers).subspan(i * exercise.outputs, exercise.outputs));
    return answers;
}

Verdict judge(const Exercise& exercise, const std::vector<Case>& cases, std::span<const double> given) {
    std::vector<double> answers(given.begin(), given.end());
    answers.resize(cases.size() * exercise.outputs, std::numeric_limits<double>::quiet_NaN());
    Verdict verdict;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto judgement = exercise.judge(cases[i], answer_to(exercise, i, answers));
        const bool right = judgement.outcome == Judgement::Outcome::right;
        auto& score = score_of(verdict.groups, cases[i]);
        ++score.total;
        score.right += right;
        if (cases[i].kind != Case::Kind::graded) continue;
        ++verdict.total;
        verdict.right += right;
        if (!right && !verdict.first_wrong)
            verdict.first_wrong =
                WrongCase{i, cases[i].group, exercise.story(cases[i]), judgement.expected, judgement.got};
    }
    std::ranges::stable_partition(verdict.groups, [](const auto& s) { return s.kind == Case::Kind::graded; });
    if (!verdict.passed()) verdict.hint = matching_hint(exercise, cases, answers);
    return verdict;
}

Verdict with_work(Verdict verdict, const Exercise& exercise, const std::vector<Case>& cases,
                  std::vector<WorkScore> work) {
    verdict.work = std::move(work);
    if (verdict.passed() || !verdict.answers_right()) return verdict;
    for (const auto& [name, hint, answer] : exercise.mistakes) {
        if (!is_right(exercise, cases, answer)) continue;
        const auto theirs = work_scores(exercise, answer);
        if (!std::ranges::equal(theirs, verdict.work, {}, &WorkScore::passed, &WorkScore::passed)) continue;
        verdict.hint = hint;
        break;
    }
    return verdict;
}

std::optional<std::string> matching_hint(const Exercise& exercise, const std::vector<Case>& cases,
                                         std::span<const double> answers) {
    std::vector<bool> right;
    for (std::size_t i = 0; i < cases.size(); ++i)
        right.push_back(exercise.judge(cases[i], answer_to(exercise, i, answers)).outcome == Judgement::Outcome::right);
    const Told yours{answers, symptoms_of(exercise, cases, answers)};
    std::optional<std::string> best;
    double best_score = 0.5;  // explaining less than this would be a guess
    for (const auto& [name, hint, answer] : exercise.mistakes) {
        const auto mistaken = answers_of(exercise, answer, cases);
        const auto score =
            likeness(exercise, cases, yours, right, {mistaken, symptoms_of(exercise, cases, mistaken)}).score();
        if (score <= best_score) continue;
        best = hint;
        best_score = score;
    }
    return best;
}

}  // namespace raylab::grading
