#include "student.h"

#include "answering.h"

#include "raylab/base/printable.h"
#include "raylab/base/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>
#include <numeric>

namespace raylab::grading {

namespace {

constexpr double reference_times = 10;  // as long as the reference takes, a right answer may be slower
constexpr double least_seconds = 2;
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
        case ProcessResult::End::objected:  // to files that it wrote, and an answer writes none
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
    return {.input = bytes_of(input), .output_limit = max_bytes + 65536};
}

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The seconds for a program that does what `by_reference` does with the reference.
unsigned seconds_for(const auto& by_reference) {
    const double start = thread_seconds();
    by_reference();
    return static_cast<unsigned>(std::ceil(std::max(least_seconds, reference_times * (thread_seconds() - start))));
}

unsigned seconds_for(const Exercise& exercise, std::span<const double> inputs) {
    return seconds_for([&] {
        std::vector<double> output(exercise.outputs);
        for (; inputs.size() >= exercise.inputs; inputs = inputs.subspan(exercise.inputs))
            exercise.reference(inputs.first(exercise.inputs), output);
    });
}

// What a student has done who reads of this signal for the first time.
std::string meaning_of(int signal) {
    switch (signal) {
        case SIGSEGV:
        case SIGBUS:
            return ": it read or wrote memory that is not its own: an index beyond the end, a null pointer, or a function "
                   "that calls itself without end";
        case SIGABRT:
            return ": an assertion failed, which it printed, or abort() was called";
        case SIGFPE:
            return ": a whole number was divided by 0";
        case SIGXFSZ:
            return ": it wrote to a file";
        default:
            return "";
    }
}

// Where in its output the student's process says what was thrown; none: it ended otherwise.
std::size_t place_of_thrown(const ProcessResult& result) {
    const bool thrown = result.end == ProcessResult::End::exited && result.code == exit_thrown;
    return thrown ? result.errors.rfind(thrown_words) : std::string::npos;
}

std::string reason_of(const ProcessResult& result, const Allowed& allowed) {
    if (const auto at = place_of_thrown(result); at != std::string::npos)
        return "it threw an exception: " +
               on_one_line(harmless(result.errors.substr(at + std::string_view(thrown_words).size())));
    if (result.end != ProcessResult::End::signalled) return to_string(result);
    if (end_of_killed(result.code) == Answers::End::timed_out)  // Which of the two clocks it was that ran out.
        return fmt::format("it took more than {} s of the processor's time", allowed.seconds);
    return to_string(result) + meaning_of(result.code);
}

Answers answers_in(const ProcessResult& result, const Program& program, std::size_t max_bytes, bool all_there) {
    Answers answers{.end = end_of(result, all_there),
                    .reason = reason_of(result, program.allowed),
                    .printed = harmless(result.errors.substr(0, place_of_thrown(result))),
                    .seconds = result.cpu_seconds};
    const std::size_t case_bytes = program.outputs * sizeof(double);
    const std::size_t whole = std::min(result.output.size(), max_bytes) / case_bytes * case_bytes;
    answers.values.resize(whole / sizeof(double));
    std::memcpy(answers.values.data(), result.output.data(), whole);
    return answers;
}

// Records of this many doubles, from last to first.
std::vector<double> from_last(std::span<const double> values, std::size_t record) {
    std::vector<double> reversed;
    for (std::size_t i = values.size() / record; i-- > 0;) {
        const auto one = values.subspan(i * record, record);
        reversed.insert(reversed.end(), one.begin(), one.end());
    }
    return reversed;
}

// The programs that count work are completed by the loader, which opens libraries.
Program program_of(const Exercise& exercise, const Workplace& workplace, unsigned seconds) {
    const Work work = exercise.work.empty() ? Work::answer : Work::load_and_answer;
    return {workplace.isolated(), {work, seconds}, workplace.program(), exercise.inputs, exercise.outputs};
}

}  // namespace

Answers run(const Exercise& exercise, const Workplace& workplace, std::span<const double> inputs) {
    return run(program_of(exercise, workplace, seconds_for(exercise, inputs)), inputs);
}

Answers run_from_last(const Exercise& exercise, const Workplace& workplace, std::span<const double> inputs) {
    auto answers = run(exercise, workplace, from_last(inputs, exercise.inputs));
    if (answers.end == Answers::End::complete) answers.values = from_last(answers.values, exercise.outputs);
    return answers;
}

Answers run(const Program& program, std::span<const double> inputs) {
    const std::size_t wanted = inputs.size() / program.inputs * program.outputs * sizeof(double);
    const auto result = run_isolated(program.isolated, program.allowed, program.path, {}, options(inputs, wanted));
    return answers_in(result, program, wanted, result.output.size() == wanted);
}

Answers run_work(const Exercise& exercise, const Workplace& workplace, std::span<const double> max_questions) {
    const double questions = std::reduce(max_questions.begin(), max_questions.end());
    const std::size_t largest = static_cast<std::size_t>(questions) * exercise.outputs * sizeof(double);
    const auto seconds = seconds_for([&] {
        for (const WorkTask& task : exercise.work) task.trace(exercise.reference);
    });
    const auto program = program_of(exercise, workplace, seconds);
    const auto result =
        run_isolated(program.isolated, program.allowed, program.path, {"work"}, options(max_questions, largest));
    return answers_in(result, program, largest, true);
}

}  // namespace raylab::grading
