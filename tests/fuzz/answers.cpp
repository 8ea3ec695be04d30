#include "raylab/base/bytes.h"

#include "exercise.h"
#include "fuzz/value_or_error.h"

#include <cassert>

using namespace raylab::grading;

namespace {

constexpr std::size_t max_questions = 1000;  // of a task's rays

struct AskedExercise {
    const Exercise& exercise;
    std::vector<Case> cases;
};

const std::vector<AskedExercise>& asked_exercises() {
    static const auto all = [] {
        std::vector<AskedExercise> asked;
        for (const Exercise& exercise : exercises()) asked.push_back({exercise, exercise.cases(1)});
        return asked;
    }();
    return all;
}

std::vector<double> doubles(std::string_view bytes) {
    std::vector<double> numbers(bytes.size() / sizeof(double));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = raylab::number_at<double>(bytes, i * sizeof(double), std::endian::native);
    return numbers;
}

// Gives the numbers as answers one after another, as a student's process would.
void say(std::span<const double> said, const WorkTask& task) {
    traced(task, max_questions, [&](std::span<const double>, std::span<double> output) {
        if (said.size() < output.size()) throw NoAnswer{};
        std::ranges::copy(said.first(output.size()), output.begin());
        said = said.subspan(output.size());
    });
}

}  // namespace

// Any doubles are answers that a judge can judge: the first byte chooses the exercise, the second the case.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return value_or_error(data, size, [](std::string_view bytes) {
        if (bytes.size() < 2) return;
        const auto chosen = [](char byte, const auto& all) { return static_cast<std::uint8_t>(byte) % all.size(); };
        const auto& [exercise, cases] = asked_exercises()[chosen(bytes[0], asked_exercises())];
        std::vector<double> said = doubles(bytes.substr(2));
        for (const WorkTask& task : exercise.work) say(said, task);
        said.resize(exercise.outputs, std::numeric_limits<double>::quiet_NaN());
        const auto judgement = exercise.judge(cases[chosen(bytes[1], cases)], said);
        assert(!judgement.expected.empty() && !judgement.got.empty());
    });
}
