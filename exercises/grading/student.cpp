#include "student.h"

#include "answering.h"

#include "raylab/base/printable.h"
#include "raylab/base/process.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <numeric>

namespace raylab::grading {

namespace {

// Seconds of the clock for all cases. The launcher bounds the processor's time (five seconds, a thousand times that of
// a right answer), which does not depend on what else runs; this is for those who only wait.
constexpr double patience = 22;
constexpr std::size_t shown_bytes = 2000;  // the part of a student's output that is shown

// Escapes control characters, which could repaint the terminal on which the verdict is read.
std::string harmless(std::string text) {
    if (text.size() > shown_bytes) text = text.substr(0, shown_bytes) + "...";
    return printable_lines(text);
}

std::string bytes_of(std::span<const double> values) {
    std::string bytes(values.size_bytes(), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

Answers::End end_of_killed(int signal) {
    if (signal == SIGXCPU || signal == SIGKILL) return Answers::End::timed_out;  // SIGKILL: it ignored the other
    return signal == SIGSYS ? Answers::End::policy : Answers::End::crashed;
}

Answers::End end_of(const ProcessResult& result, bool all_there) {
    switch (result.end) {
        case ProcessResult::End::signalled:
            return end_of_killed(result.code);
        case ProcessResult::End::timed_out:
            return Answers::End::timed_out;
        case ProcessResult::End::flooded:
            return Answers::End::flooded;
        case ProcessResult::End::exited:
            break;
    }
    if (result.code == exit_unfinished) return Answers::End::unfinished;
    if (result.code == exit_out_of_memory) return Answers::End::out_of_memory;
    if (result.code == exit_thrown) return Answers::End::crashed;
    return result.code == 0 && all_there ? Answers::End::complete : Answers::End::incomplete;
}

ProcessOptions options(std::span<const double> input, std::size_t max_bytes) {
    return {.input = bytes_of(input), .timeout = patience, .output_limit = max_bytes + 65536};
}

Answers answers_in(const ProcessResult& result, std::size_t outputs, std::size_t max_bytes, bool all_there) {
    Answers answers{.end = end_of(result, all_there),
                    .reason = to_string(result),
                    .printed = harmless(result.errors),
                    .seconds = result.seconds};
    const std::size_t case_bytes = outputs * sizeof(double);
    const std::size_t whole = std::min(result.output.size(), max_bytes) / case_bytes * case_bytes;
    answers.values.resize(whole / sizeof(double));
    std::memcpy(answers.values.data(), result.output.data(), whole);
    return answers;
}

// The programs that count work are completed by the loader, which opens libraries.
Program program_of(const Exercise& exercise, const Workplace& workplace) {
    return {workplace.isolated(), exercise.work.empty() ? Work::answer : Work::load_and_answer, workplace.program(),
            exercise.inputs, exercise.outputs};
}

}  // namespace

Answers run(const Exercise& exercise, const Workplace& workplace, std::span<const double> inputs) {
    return run(program_of(exercise, workplace), inputs);
}

Answers run(const Program& program, std::span<const double> inputs) {
    const std::size_t wanted = inputs.size() / program.inputs * program.outputs * sizeof(double);
    const auto result = run_isolated(program.isolated, program.work, program.path, {}, options(inputs, wanted));
    return answers_in(result, program.outputs, wanted, result.output.size() == wanted);
}

Answers run_work(const Exercise& exercise, const Workplace& workplace, std::span<const double> max_questions) {
    const double questions = std::reduce(max_questions.begin(), max_questions.end());
    const std::size_t largest = static_cast<std::size_t>(questions) * exercise.outputs * sizeof(double);
    const auto program = program_of(exercise, workplace);
    const auto result =
        run_isolated(program.isolated, program.work, program.path, {"work"}, options(max_questions, largest));
    return answers_in(result, exercise.outputs, largest, true);
}

}  // namespace raylab::grading
