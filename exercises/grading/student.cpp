#include "student.h"

#include "answering.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/printable.h"
#include "raylab/base/process.h"
#include "raylab/report/build_target.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <sstream>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

const fs::path build_folder = RAYLAB_BUILD;
constexpr double patience = 5;             // seconds for all cases: a thousand times the time of a right answer
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

Answers::End end_of(const ProcessResult& result, bool all_there) {
    switch (result.end) {
        case ProcessResult::End::signalled:
            return Answers::End::crashed;
        case ProcessResult::End::timed_out:
            return Answers::End::timed_out;
        case ProcessResult::End::flooded:
            return Answers::End::flooded;
        case ProcessResult::End::exited:
            break;
    }
    if (result.code == exit_unfinished) return Answers::End::unfinished;
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

// Whether the symbol is "raylab::nearest_sphere_hit(...)" or its cold part.
bool belongs_to_slot(const std::string& symbol, const std::string& slot) {
    return symbol.starts_with("raylab::" + slot + "(");
}

bool comes_with_the_headers(const std::string& symbol) {
    static const std::vector<std::string> origins{"std::",        "glm::",      "__gnu_cxx::",
                                                  "operator new", "typeinfo",   "vtable",
                                                  "raylab::",     "void glm::", "DW.ref.__gxx_personality_v0"};
    return std::ranges::any_of(origins, [&](const auto& origin) { return symbol.find(origin) != std::string::npos; });
}

}  // namespace

fs::path program_of(const Exercise& exercise) { return build_folder / "exercises" / exercise.folder / exercise.folder; }

Compiled compile(const Exercise& exercise, const fs::path& file) {
    // The copy contains a #line directive, so that the compiler's messages name the student's own file and lines.
    const auto copy = build_folder / "exercises" / exercise.folder / (exercise.slot + ".cpp");
    write_file(copy, "#line 1 \"" + file.lexically_normal().string() + "\"\n" + read_file(file, 1 << 20));
    const auto result = build_target(exercise.folder);
    Compiled compiled{.succeeded = result.succeeded(), .seconds = result.seconds};
    if (!compiled.succeeded) {
        compiled.diagnostics = result.output + result.errors;
        return compiled;
    }
    const auto object = build_folder / "exercises/CMakeFiles" / ("student_" + exercise.folder + ".dir") /
                        exercise.folder / (exercise.slot + ".cpp.o");
    for (const auto& symbol : foreign_symbols(object, exercise.slot))
        compiled.diagnostics += "the file defines " + symbol + ", which is not " + exercise.slot +
                                ": put helpers into an unnamed namespace (namespace { ... })\n";
    compiled.succeeded = compiled.diagnostics.empty();
    return compiled;
}

std::vector<std::string> foreign_symbols(const fs::path& object, const std::string& slot) {
    const auto listing =
        run_process(find_program("nm"), {"-C", "--defined-only", "--extern-only", object.string()}, {.timeout = 10});
    if (!listing.succeeded())
        throw Error({object.string()}, "an object file that nm can read", failure_of("nm", listing));
    std::vector<std::string> foreign;
    std::istringstream lines(listing.output);
    for (std::string line; std::getline(lines, line);) {
        if (line.size() < 20) continue;  // "0123456789abcdef T name"
        const char kind = line[17];
        const auto symbol = line.substr(19);
        const bool weak = std::strchr("WVuwv", kind) != nullptr;
        if (belongs_to_slot(symbol, slot) || (weak && comes_with_the_headers(symbol))) continue;
        foreign.push_back(symbol);
    }
    return foreign;
}

Answers run(const Exercise& exercise, std::span<const double> inputs) {
    return run(Program{program_of(exercise), exercise.inputs, exercise.outputs}, inputs);
}

Answers run(const Program& program, std::span<const double> inputs) {
    const std::size_t wanted = inputs.size() / program.inputs * program.outputs * sizeof(double);
    const auto result = run_process(program.path, {}, options(inputs, wanted));
    return answers_in(result, program.outputs, wanted, result.output.size() == wanted);
}

Answers run_work(const Exercise& exercise, std::span<const double> max_questions) {
    const double questions = std::reduce(max_questions.begin(), max_questions.end());
    const std::size_t largest = static_cast<std::size_t>(questions) * exercise.outputs * sizeof(double);
    const auto result = run_process(program_of(exercise), {"work"}, options(max_questions, largest));
    return answers_in(result, exercise.outputs, largest, true);
}

}  // namespace raylab::grading
