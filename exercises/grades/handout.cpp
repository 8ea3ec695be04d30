#include "handout.h"

#include "exercise.h"
#include "handout_lessons.h"
#include "quiz_seal.h"
#include "workplace.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

void copy_to(const fs::path& from, const fs::path& to) {
    fs::create_directories(to.parent_path());
    fs::copy(from, to, fs::copy_options::recursive);
}

// Without names that tell of references and mistakes.
void strip(const fs::path& file, const std::string& what) {
    const auto result = run_process("strip", {what, file.string()}, {.timeout = 60});
    if (!result.succeeded()) throw Error({file.string()}, "to be stripped", failure_of("strip", result));
}

void copy_programs(const fs::path& folder) {
    const auto build = folder / "build/release";
    for (const auto* program : {"raylab", "exercises/raylab_isolated"}) {
        copy_to(build_folder() / program, build / program);
        strip(build / program, "--strip-all");
    }
    for (const auto& entry : fs::directory_iterator(build_folder() / "exercises/harness")) {
        if (entry.path().extension() != ".o") continue;
        const auto copy = build / "exercises/harness" / entry.path().filename();
        copy_to(entry.path(), copy);
        strip(copy, "--strip-debug");  // its symbols are what an answer is linked by
    }
}

// The hints without the name of the reference's file, which is not given out.
std::string without_reference(const std::string& hints) {
    std::istringstream lines(hints);
    std::string text;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("file = \"")) text += line + "\n";
    return text;
}

// What students read: texts and drawings, and the stub. What asks and judges stays behind.
void copy_exercise(const Exercise& exercise, const fs::path& folder) {
    const auto from = source_folder() / "exercises" / exercise.folder, to = folder / "exercises" / exercise.folder;
    constexpr std::array<std::string_view, 4> read{".md", ".toml", ".svg", ".png"};
    for (const auto& entry : fs::directory_iterator(from)) {
        const auto extension = entry.path().extension().string();
        if (entry.path().filename() == "contract.toml") continue;  // names mistakes, and what catches them
        if (entry.path().filename() == "quiz.toml")
            write_file(to / "quiz.toml", sealed_quiz(read_file(entry.path())));
        else if (entry.path().filename() == "hints.toml")
            write_file(to / "hints.toml", without_reference(read_file(entry.path())));
        else if (entry.is_regular_file() && std::ranges::find(read, extension) != read.end())
            copy_to(entry.path(), to / entry.path().filename());
    }
    copy_to(from / (exercise.slot + ".cpp"), to / (exercise.slot + ".cpp"));
    write_file(to / headers_file, fmt::format("{}\n", fmt::join(visible_headers(exercise), "\n")));
}

void copy_headers(const fs::path& folder) {
    std::set<std::string> headers;
    for (const auto& exercise : exercises())
        for (auto& header : visible_headers(exercise)) headers.insert(std::move(header));
    for (const auto& header : headers) copy_to(source_folder() / "lib" / header, folder / "lib" / header);
}

// The Debian packages of the libraries that the program was linked with.
std::set<std::string> packages() {
    std::set<std::string> all{"fonts-dejavu-core", "g++",        "libfmt-dev", "libglm-dev",
                              "libgmp-dev",        "libhwy-dev", "libseccomp2"};
    std::istringstream lines(run_process("ldd", {(build_folder() / "raylab").string()}).output);
    for (std::string line; std::getline(lines, line);) {
        const auto begin = line.find("=> /"), end = line.find(" (");
        if (begin == line.npos || end == line.npos || find_program("dpkg-query").empty()) continue;
        const auto library = fs::weakly_canonical(line.substr(begin + 3, end - begin - 3));
        const auto owner = run_process("dpkg-query", {"-S", library.string()});
        if (owner.succeeded()) all.insert(owner.output.substr(0, owner.output.find(':')));
    }
    return all;
}

std::string list_of_exercises() {
    std::string text;
    for (const auto& exercise : exercises())
        text += fmt::format("\n- [{0}](exercises/{0}/README.md): `{1}`; chapter [{2}](chapters/{2}/README.md)",
                            exercise.folder, exercise.slot, exercise.chapter);
    return text + "\n";
}

}  // namespace

void write_handout(const fs::path& folder) {
    if (fs::exists(source_folder() / "handout.txt"))
        throw Error({source_folder().string()}, "the whole lab", "a handout, which makes no others");
    copy_programs(folder);
    for (const auto& exercise : exercises()) copy_exercise(exercise, folder);
    copy_to(source_folder() / "exercises/hints.toml", folder / "exercises/hints.toml");
    copy_headers(folder);
    const auto texts = source_folder() / "exercises/handout";
    copy_to(texts / "raylab", folder / "raylab");
    copy_to(source_folder() / "LICENSE", folder / "LICENSE");
    write_file(folder / "README.md", read_file(texts / "README.md") + list_of_exercises());
    write_file(folder / "packages.txt", fmt::format("{}\n", fmt::join(packages(), "\n")));
    write_lessons(folder);
    write_file(folder / "handout.txt", "The program finds the folder by this file.\n");
}

}  // namespace raylab::grading
