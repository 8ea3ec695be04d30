#include "compiling.h"

#include "assembly.h"
#include "source_text.h"
#include "student_words.h"
#include "symbols.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/printable.h"
#include "raylab/base/process.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <regex>
#include <sstream>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

constexpr Allowed compiling{Work::compile, 30};  // a stub takes half a second

std::vector<std::string> words_in(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

constexpr ProcessResult::End timed_out = ProcessResult::End::timed_out;

ProcessResult run_compiler(const Workplace& workplace, std::vector<std::string> words) {
    const std::string program = words.front();
    words.erase(words.begin());
    return run_isolated(workplace.isolated(), compiling, program, words, {.folder = workplace.path()});
}

// The library's parts that count work, or trace a scene, need libraries that Debian has as shared objects only.
enum class Linked { whole, with_shared_libraries };

fs::path harness_of(const std::string& name) { return build_folder() / "exercises/harness" / (name + ".o"); }

ProcessResult link(const Workplace& workplace, const std::string& harness, const fs::path& program, Linked how) {
    const auto copy = workplace.path() / (harness + ".o");  // the linker sees the workplace only
    fs::copy_file(harness_of(harness), copy);
    auto words = student_words();
    // The harness stands first: of an inline function that both have, the linker keeps the first.
    words.insert(words.end(), {copy.string(), workplace.object().string(), "-o", program.string()});
    const std::vector<std::string> libraries{"-Wl,--as-needed", "-lfmt", "-lhwy", "-lgmpxx", "-lgmp"};
    if (how == Linked::whole)
        words.emplace_back("-static");
    else
        words.insert(words.end(), libraries.begin(), libraries.end());
    return run_compiler(workplace, std::move(words));
}

// What the linker says, a sentence for each of its messages that has a name in it.
std::vector<std::string> faults_in(const std::string& messages) {
    static const std::regex twice("multiple definition of [`']([^']+)'"),
        missing("undefined reference to [`']([^']+)'");
    std::vector<std::string> faults;
    const auto add = [&](const std::regex& pattern, const auto& sentence) {
        for (std::sregex_iterator match(messages.begin(), messages.end(), pattern), end; match != end; ++match) {
            auto fault = sentence((*match)[1].str());
            if (std::ranges::find(faults, fault) == faults.end()) faults.push_back(std::move(fault));
        }
    };
    add(twice, [](const std::string& name) {
        return "the file defines " + name +
               ", which the lab defines itself: choose another name, or put it into an "
               "unnamed namespace (namespace { ... })";
    });
    add(missing, [](const std::string& name) {
        return "the file calls " + name + ", which nothing defines that an answer is linked with";
    });
    if (faults.empty()) faults.push_back("the linker refuses the file: " + on_one_line(messages));
    return faults;
}

std::string lines_of(const std::vector<std::string>& sentences) {
    std::string text;
    for (const auto& sentence : sentences) text += sentence + "\n";
    return text;
}

// The file is compiled to assembly, and that is read before an assembler sees it: it could put other files into the
// object.
ProcessResult run_compiler_alone(const Workplace& workplace) {
    auto words = student_words();
    words.insert(words.end(), {"-I", workplace.headers().string(), "-MD", "-MF", workplace.dependencies().string(),
                               "-S", workplace.source().filename().string(), "-o", workplace.assembly().string()});
    return run_compiler(workplace, std::move(words));
}

std::vector<std::string> faults_of_assembling(const Workplace& workplace) {
    auto faults = faults_of_assembly(read_file(workplace.assembly()));
    if (!faults.empty()) return faults;
    const auto assembled = run_compiler(
        workplace, {student_words().front(), "-c", workplace.assembly().string(), "-o", workplace.object().string()});
    if (!assembled.succeeded()) faults.push_back(failure_of("the assembler", assembled));
    return faults;
}

// The reasons why the file is no answer; none, where it was assembled and linked.
std::vector<std::string> faults_after_compiling(const Exercise& exercise, const Workplace& workplace) {
    auto faults = faults_of_includes(included_files(workplace.dependencies()), workplace.headers());
    if (!faults.empty()) return faults;
    faults = faults_of_assembling(workplace);
    if (!faults.empty()) return faults;
    faults = faults_of(symbols_of(workplace.object()), exercise.slot, harness_of(exercise.folder));
    if (!faults.empty()) return faults;
    const auto linked = link(workplace, exercise.folder, workplace.program(),
                             exercise.work.empty() ? Linked::whole : Linked::with_shared_libraries);
    return linked.succeeded() ? std::vector<std::string>{} : faults_in(linked.output + linked.errors);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Compiled compile(const Exercise& exercise, const Workplace& workplace, const fs::path& file) {
    const auto start = std::chrono::steady_clock::now();
    const auto text = source_text(file);
    if (const auto faults = faults_of_directives(text); !faults.empty())
        return {.succeeded = false, .refused = true, .seconds = 0, .diagnostics = lines_of(faults)};
    write_file(workplace.source(), text);
    const auto result = run_compiler_alone(workplace);
    Compiled compiled{.succeeded = result.succeeded(),
                      .refused = false,
                      .seconds = 0,
                      .diagnostics = shown_messages(result.output + result.errors, workplace.source(), file)};
    if (result.end == timed_out) compiled.diagnostics = "compiling " + to_string(result) + "\n";
    if (compiled.succeeded) {
        const auto faults = faults_after_compiling(exercise, workplace);
        compiled.succeeded = faults.empty();
        compiled.refused = !faults.empty();
        compiled.diagnostics += lines_of(faults);
    } else if (asks_for_other_headers(result.errors)) {
        compiled.diagnostics += fmt::format("An answer may include the standard library, GLM and {}.\n",
                                            fmt::join(visible_headers(exercise), ", "));
    }
    compiled.seconds = seconds_since(start);
    return compiled;
}

void link_tracer(const Exercise& exercise, const Workplace& workplace) {
    const auto linked = link(workplace, exercise.folder + ".traced", workplace.tracer(), Linked::with_shared_libraries);
    if (!linked.succeeded()) throw Error("linking a tracer with this function, " + failure_of("the linker", linked));
}

// The chapter's program is linked as the build links it, but for one object.
void link_chapter(const Exercise& exercise, const Workplace& workplace) {
    const auto program = "chapters/" + exercise.chapter + "/" + exercise.chapter;
    const auto listed = run_process("ninja", {"-C", build_folder().string(), "-t", "commands", "-s", program});
    if (!listed.succeeded())
        throw Error("how chapter " + exercise.chapter + " is linked, " + failure_of("ninja", listed));
    auto words = words_in(listed.output);  // ": && c++ ... -o <program> ... && :"
    std::erase_if(words, [](const auto& word) { return word == ":" || word == "&&"; });
    std::ranges::replace(words, program, workplace.chapter().string());
    std::ranges::replace_if(
        words, [&](const auto& word) { return word.ends_with("/slot/" + exercise.slot + ".cpp.o"); },
        workplace.object().string());
    const std::string compiler = words.front();
    words.erase(words.begin());
    const auto linked = run_process(compiler, words, {.folder = build_folder(), .timeout = compiling.patience()});
    if (!linked.succeeded())
        throw Error("linking chapter " + exercise.chapter + " with this function, " + failure_of("the linker", linked));
}

}  // namespace raylab::grading
