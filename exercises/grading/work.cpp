#include "work.h"

#include <algorithm>

namespace raylab::grading {

namespace {

// A task's questions with their answers.
struct Exchange {
    std::vector<double> input, output;
};
using Exchanges = std::vector<Exchange>;

struct ReferenceWork {
    Worked worked;
    std::size_t questions = 0;
};

ReferenceWork by_reference(const Exercise& exercise, const WorkTask& task) {
    ReferenceWork result;
    result.worked = task.trace([&](std::span<const double> input, std::span<double> output) {
        ++result.questions;
        exercise.reference(input, output);
    });
    return result;
}

std::size_t largest(const ReferenceWork& reference) {
    return static_cast<std::size_t>(work_watched * static_cast<double>(reference.questions));
}

// The first wrong answer among those to a task's questions.
std::optional<WrongCase> first_wrong(const Exercise& exercise, const WorkTask& task, const Exchanges& asked) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const Case question{task.rays, Case::Kind::graded, asked[i].input};
        const auto judgement = exercise.judge(question, asked[i].output);
        if (judgement.outcome != Judgement::Outcome::right)
            return WrongCase{i, task.rays, exercise.story(question), judgement.expected, judgement.got};
    }
    return std::nullopt;
}

WorkScore score(const WorkTask& task, const Worked& reference, const std::optional<Worked>& yours) {
    const std::size_t rays = reference.hits.size();
    const double each = reference.work / static_cast<double>(rays);
    WorkScore score{
        .rays = task.rays, .unit = task.unit, .reference = each, .allowed = work_allowed * each, .total = rays};
    if (!yours) return score;
    score.yours = yours->work / static_cast<double>(rays);
    for (std::size_t i = 0; i < rays; ++i) score.strayed += yours->hits[i] != reference.hits[i];
    return score;
}

}  // namespace

std::vector<double> max_questions(const Exercise& exercise) {
    std::vector<double> all;
    for (const WorkTask& task : exercise.work)
        all.push_back(static_cast<double>(largest(by_reference(exercise, task))));
    return all;
}

std::vector<WorkScore> work_scores(const Exercise& exercise, const Answer& answer) {
    std::vector<WorkScore> scores;
    for (const WorkTask& task : exercise.work) {
        const auto reference = by_reference(exercise, task);
        Exchanges asked;
        const auto noted = [&](std::span<const double> input, std::span<double> output) {
            answer(input, output);
            asked.push_back({{input.begin(), input.end()}, {output.begin(), output.end()}});
        };
        auto judged = score(task, reference.worked, traced(task, largest(reference), noted));
        if (judged.strayed > 0) judged.astray = first_wrong(exercise, task, asked);
        scores.push_back(std::move(judged));
    }
    return scores;
}

std::vector<WorkScore> work_scores(const Exercise& exercise, std::span<const double> said) {
    return work_scores(exercise, [&](std::span<const double>, std::span<double> output) {
        if (said.size() < output.size()) throw NoAnswer{};
        std::ranges::copy(said.first(output.size()), output.begin());
        said = said.subspan(output.size());
    });
}

}  // namespace raylab::grading
