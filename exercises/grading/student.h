#pragma once

#include "workplace.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

// A student's function runs in a process of its own that never sees a reference and reports no verdict.

namespace raylab::grading {

/// The output of the student's process.
struct Answers {
    // policy: it did what no answer has to do, and was killed for it
    enum class End {
        complete,
        unfinished,
        incomplete,
        crashed,
        timed_out,
        out_of_memory,
        flooded,
        policy
    } end = End::complete;
    std::vector<double> values;  // of whole cases only
    std::string reason;          // "killed by signal 11 (Segmentation fault)"
    std::string printed;         // what the function printed, shortened and with control characters escaped
    double seconds = 0;          // of the processor
};

/// A program that contains the student's function and answers cases of this many doubles.
struct Program {
    Isolated isolated;
    Allowed allowed;
    std::filesystem::path path;
    std::size_t inputs, outputs;
};

/// Runs it on inputs (whole cases), with a limit on time and output.
Answers run(const Program& program, std::span<const double> inputs);

/// Runs the exercise's program, as it was compiled in the workplace. It gets ten times the processor's time that the
/// reference takes for these inputs, and at least two seconds.
Answers run(const Exercise& exercise, const Workplace& workplace, std::span<const double> inputs);

/// The answers of a new process that is asked the same cases from last to first, in the order of the cases: those of a
/// function that keeps nothing from one call to the next are the same. Of a process that ended before its time they are
/// in the order in which they came.
Answers run_from_last(const Exercise& exercise, const Workplace& workplace, std::span<const double> inputs);

/// The answers of the compiled function to the calls of the exercise's tasks (work.h), at most this many for each task.
/// Only a judge that traces the same rays knows how many there should be.
Answers run_work(const Exercise& exercise, const Workplace& workplace, std::span<const double> max_questions);

}  // namespace raylab::grading
