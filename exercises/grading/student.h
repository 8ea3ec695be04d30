#pragma once

#include "exercise.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

// A student's file: compiled, looked at, run in a process of its own that never sees a reference and reports no verdict.

namespace raylab::grading {

/// What became of compiling a student's file.
struct Compiled {
    bool succeeded = false;
    double seconds = 0;
    std::string diagnostics;  // the compiler's words, with the student's file and lines; or what the object defines too much
};

/// Puts the file where the build takes it from and builds the exercise's program. Error where there is no such file.
Compiled compile(const Exercise& exercise, const std::filesystem::path& file);

/// The global symbols of an object file that the slot may not define: anything strong but the function itself, and
/// anything weak outside the standard library, GLM and the library's own templates.
std::vector<std::string> foreign_symbols(const std::filesystem::path& object, const std::string& slot);

/// What came back from the student's process.
struct Answers {
    enum class End { complete, unfinished, incomplete, crashed, timed_out, flooded } end = End::complete;
    std::vector<double> values;  // whole cases only
    std::string reason;          // "killed by signal 11 (Segmentation fault)"
    std::string printed;         // what the function printed, shortened, made harmless
    double seconds = 0;
};

/// A program with the student's function in it, which answers cases of so many doubles.
struct Program {
    std::filesystem::path path;
    std::size_t inputs, outputs;
};

/// Runs it on inputs (whole cases), with a limit on time and output.
Answers run(const Program& program, std::span<const double> inputs);

/// The same with the compiled exercise.
Answers run(const Exercise& exercise, std::span<const double> inputs);

/// The answers of the compiled function to what the exercise's tasks ask it (work.h), each at most so often. Only a
/// judge that traces the same rays knows how many they should be.
Answers run_work(const Exercise& exercise, std::span<const double> most_questions);

/// Where the build has the exercise's program and its object file.
std::filesystem::path program_of(const Exercise& exercise);

}  // namespace raylab::grading
