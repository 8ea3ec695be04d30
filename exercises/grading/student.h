#pragma once

#include "exercise.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

// A student's file: it is compiled, its symbols are checked, and it runs in a process of its own that never sees a
// reference and reports no verdict.

namespace raylab::grading {

/// The result of compiling a student's file.
struct Compiled {
    bool succeeded = false;
    double seconds = 0;
    // The compiler's messages, with the student's file and lines; or the symbols that the object must not define.
    std::string diagnostics;
};

/// Copies the file to where the build expects it and builds the exercise's program. It throws an Error where there is
/// no such file.
Compiled compile(const Exercise& exercise, const std::filesystem::path& file);

/// The global symbols of an object file that the slot may not define: any strong one except the function itself, and
/// any weak one outside the standard library, GLM and the library's own templates.
std::vector<std::string> foreign_symbols(const std::filesystem::path& object, const std::string& slot);

/// The output of the student's process.
struct Answers {
    enum class End { complete, unfinished, incomplete, crashed, timed_out, flooded } end = End::complete;
    std::vector<double> values;  // of whole cases only
    std::string reason;          // "killed by signal 11 (Segmentation fault)"
    std::string printed;         // what the function printed, shortened and with control characters escaped
    double seconds = 0;
};

/// A program that contains the student's function and answers cases of this many doubles.
struct Program {
    std::filesystem::path path;
    std::size_t inputs, outputs;
};

/// Runs it on inputs (whole cases), with a limit on time and output.
Answers run(const Program& program, std::span<const double> inputs);

/// Runs the compiled exercise.
Answers run(const Exercise& exercise, std::span<const double> inputs);

/// The answers of the compiled function to the calls of the exercise's tasks (work.h), at most this many for each task.
/// Only a judge that traces the same rays knows how many there should be.
Answers run_work(const Exercise& exercise, std::span<const double> max_questions);

/// The paths of the exercise's program and its object file in the build folder.
std::filesystem::path program_of(const Exercise& exercise);

}  // namespace raylab::grading
