#include "known_mistakes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::grading {

namespace {

// What of an answer tells mistakes apart. Numbers count as the same mistake's if they agree to far more digits than a
// judge's tolerance, and fingerprints if they agree up to their noise.
std::vector<double> fingerprint_of(const Exercise& exercise, const Case& question, std::span<const double> answer) {
    return exercise.fingerprint ? exercise.fingerprint(question, answer) : std::vector(answer.begin(), answer.end());
}

bool same_fingerprint(std::span<const double> a, std::span<const double> b, double noise) {
    return std::ranges::equal(a, b, [noise](double x, double y) {
        if (std::isnan(x) || std::isnan(y)) return std::isnan(x) && std::isnan(y);
        if (std::isinf(x) || std::isinf(y)) return x == y;
        return std::abs(x - y) <= noise * std::max({1.0, std::abs(x), std::abs(y)});
    });
}

std::vector<double> answer_by(const Exercise& exercise, const Answer& answer, const Case& question) {
    std::vector<double> numbers(exercise.outputs, std::numeric_limits<double>::quiet_NaN());
    answer(question.input, numbers);
    return numbers;
}

// The graded cases of a student, and what tells the mistakes of those that are wrong.
struct Graded {
    struct Asked {
        std::size_t index;
        std::vector<double> fingerprint;
    };
    std::vector<Asked> wrong, right;
};

Graded graded(const Exercise& exercise, const std::vector<Case>& cases, std::span<const double> answers,
              const Outcomes& outcomes) {
    const auto asked = [&](const std::vector<std::size_t>& indices) {
        std::vector<Graded::Asked> all;
        for (const std::size_t i : indices)
            all.push_back(
                {i, fingerprint_of(exercise, cases[i], answers.subspan(i * exercise.outputs, exercise.outputs))});
        return all;
    };
    return {asked(outcomes.wrong), asked(outcomes.right)};
}

// Whether the mistake's answer is one that is wrong as the student's is.
bool is_as_wrong(const Exercise& exercise, const Case& question, std::span<const double> fingerprint,
                 std::span<const double> mistaken) {
    if (!same_fingerprint(fingerprint, fingerprint_of(exercise, question, mistaken), exercise.fingerprint_noise))
        return false;
    // The same numbers are as wrong; fingerprints may agree within their noise where only one of the two is wrong.
    return !exercise.fingerprint || exercise.judge(question, mistaken).outcome != Judgement::Outcome::right;
}

// How well a known mistake explains the wrong answers: the share of them that are the mistake's. What the mistake gets
// wrong and the student right counts against it, by half: that distinguishes a special mistake from a general one that
// happens to share its wrong answers. Absent where it is at most `least`, which is mostly known before all are asked.
std::optional<double> likeness(const Exercise& exercise, const std::vector<Case>& cases, const Graded& yours,
                               const Answer& mistake, double least) {
    const double all = static_cast<double>(std::max<std::size_t>(yours.wrong.size(), 1));
    double likeness = 1;  // as long as nothing is against it
    for (const auto& [index, fingerprint] : yours.wrong) {
        if (!is_as_wrong(exercise, cases[index], fingerprint, answer_by(exercise, mistake, cases[index])))
            likeness -= 1 / all;
        if (likeness <= least) return std::nullopt;
    }
    for (const auto& [index, fingerprint] : yours.right) {
        const auto theirs = answer_by(exercise, mistake, cases[index]);
        // Judging may be slow (it may call the oracle), so it is done only where the two differ.
        if (!same_fingerprint(fingerprint, fingerprint_of(exercise, cases[index], theirs),
                              exercise.fingerprint_noise) &&
            exercise.judge(cases[index], theirs).outcome != Judgement::Outcome::right)
            likeness -= 0.5 / all;
        if (likeness <= least) return std::nullopt;
    }
    return likeness;
}

}  // namespace

std::optional<Found> find_known_mistake(const Exercise& exercise, const std::vector<Case>& cases,
                                        std::span<const double> answers, const Outcomes& outcomes, double least) {
    const Graded yours = graded(exercise, cases, answers, outcomes);
    std::optional<Found> best;
    for (const auto& [name, hint, answer] : exercise.mistakes)
        if (const auto found = likeness(exercise, cases, yours, answer, least)) {
            best = Found{hint, "These are the numbers of a typical mistake.", outcomes.wrong.front()};
            least = *found;
        }
    return best;
}

}  // namespace raylab::grading
