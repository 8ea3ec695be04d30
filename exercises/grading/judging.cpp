#include "judging.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::grading {

namespace {

std::span<const double> answer_to(const Exercise& exercise, std::size_t index, std::span<const double> answers) {
    return answers.subspan(index * exercise.outputs, exercise.outputs);
}

// What of an answer tells mistakes apart. Numbers count as the same mistake's if they agree to far more digits than a
// judge's tolerance, and symptoms if they agree up to their noise.
std::vector<double> symptoms_of(const Exercise& exercise, const Case& question, std::span<const double> answer) {
    return exercise.symptoms ? exercise.symptoms(question, answer) : std::vector(answer.begin(), answer.end());
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

std::vector<double> answer_of(const Exercise& exercise, const Answer& answer, const Case& question) {
    std::vector<double> numbers(exercise.outputs, std::numeric_limits<double>::quiet_NaN());
    answer(question.input, numbers);
    return numbers;
}

// The graded cases of a student, and what tells the mistakes of those that are wrong.
struct Graded {
    struct Asked {
        std::size_t index;
        std::vector<double> symptoms;
    };
    std::vector<Asked> wrong, right;
};

Graded graded(const Exercise& exercise, const std::vector<Case>& cases, std::span<const double> answers) {
    Graded all;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (cases[i].kind != Case::Kind::graded) continue;
        const auto answer = answer_to(exercise, i, answers);
        const bool right = exercise.judge(cases[i], answer).outcome == Judgement::Outcome::right;
        (right ? all.right : all.wrong).push_back({i, symptoms_of(exercise, cases[i], answer)});
    }
    return all;
}

// Whether the mistake's answer is one that is wrong as the student's is.
bool is_as_wrong(const Exercise& exercise, const Case& question, std::span<const double> symptoms,
                 std::span<const double> mistaken) {
    if (!same_symptoms(symptoms, symptoms_of(exercise, question, mistaken), exercise.symptom_noise)) return false;
    // The same numbers are as wrong; symptoms may agree within their noise where only one of the two is wrong.
    return !exercise.symptoms || exercise.judge(question, mistaken).outcome != Judgement::Outcome::right;
}

// How well a known mistake explains the wrong answers: the share of them that are the mistake's. What the mistake gets
// wrong and the student right counts against it, by half: that distinguishes a special mistake from a general one that
// happens to share its wrong answers. Absent where it is at most `least`, which is mostly known before all are asked.
std::optional<double> likeness(const Exercise& exercise, const std::vector<Case>& cases, const Graded& yours,
                               const Answer& mistake, double least) {
    const double all = static_cast<double>(std::max<std::size_t>(yours.wrong.size(), 1));
    double likeness = 1;  // as long as nothing is against it
    for (const auto& [index, symptoms] : yours.wrong) {
        if (!is_as_wrong(exercise, cases[index], symptoms, answer_of(exercise, mistake, cases[index])))
            likeness -= 1 / all;
        if (likeness <= least) return std::nullopt;
    }
    for (const auto& [index, symptoms] : yours.right) {
        const auto theirs = answer_of(exercise, mistake, cases[index]);
        // Judging may be slow (it may call the oracle), so it is done only where the two differ.
        if (!same_symptoms(symptoms, symptoms_of(exercise, cases[index], theirs), exercise.symptom_noise) &&
            exercise.judge(cases[index], theirs).outcome != Judgement::Outcome::right)
            likeness -= 0.5 / all;
        if (likeness <= least) return std::nullopt;
    }
    return likeness;
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
    const Graded yours = graded(exercise, cases, answers);
    std::optional<std::string> best;
    double best_likeness = 0.5;  // explaining less than this would be a guess
    for (const auto& [name, hint, answer] : exercise.mistakes)
        if (const auto found = likeness(exercise, cases, yours, answer, best_likeness)) {
            best = hint;
            best_likeness = *found;
        }
    return best;
}

}  // namespace raylab::grading
