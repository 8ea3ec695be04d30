#pragma once

#include "level.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// An official result, as it is stored, and as each format tells it to a course's machine.

namespace raylab::grading {

/// What became of a submission.
enum class Outcome {
    pass,
    wrong,
    nonfinite,      // the first wrong answer is NaN or infinite
    too_much_work,  // every answer is right, and the work that it causes is too much
    unfinished,     // the stub as it was handed out
    incomplete,     // the program ended before all cases were answered
    crash,
    timeout,
    memory,
    output_limit,
    policy,  // it did what no answer has to do, and was killed
    does_not_compile,
    refused,        // it is C++, but no answer
    no_submission,  // there is no file that could be compiled
    internal,       // the grader failed: nothing is said about the submission
};

/// "pass", "does_not_compile".
const std::string& to_string(Outcome outcome);

/// A hundredth of a point: whole numbers are finite, and are written as they are read.
using Hundredths = int;

/// A part of an exercise: a group of cases, or work that is counted.
struct GradePart {
    std::string name;
    std::size_t right = 0, total = 0;  // cases; of work 0 or 1 of 1
    Hundredths points = 0, most = 0;   // rounded, to be shown
    std::string message = {};          // "37 of 40 cases right"

    bool passed() const { return total > 0 && right == total; }

    /// How much of the part counts, from 0 to 1.
    double share() const;
};

/// The file that was graded.
struct Submitted {
    std::string file;      // its name, without folders; one that was named itself has the name that was asked for
    std::string sha256;    // in hexadecimal digits
    std::string modified;  // UTC, as the file system has it
    std::uintmax_t bytes = 0;
    std::vector<std::string> notes = {};  // what else was there, and was ignored
};

/// The first wrong answer, for a person.
struct FirstWrong {
    std::size_t index = 0;  // among all cases
    std::string group, story, expected, got;
};

struct Grade {
    std::string exercise;      // its folder: "02_ray_sphere"
    std::string student = {};  // in a class
    Outcome outcome = Outcome::internal;
    std::string summary = "the grader did not come to an end";  // one sentence
    std::string details = {};                                   // of an end that was none
    std::vector<GradePart> parts = {};
    Hundredths most = 10000;  // points of all parts together
    std::optional<FirstWrong> first_wrong = {};
    std::string hint_id = {}, hint = {};
    Submitted submitted = {};
    std::string compiler = {};  // its messages, or why the file is refused
    std::string printed = {};   // by the student's function
    std::optional<std::uint64_t> seed = {};
    std::optional<Isolation> isolation = {};
    std::string cases_sha256 = {};  // of the cases, with the reference's answers: whether they have changed since
    // Of wrong answers to cases that are the same for everybody: equal where two submissions are wrong in the same way.
    std::string fingerprint = {};
    std::string began = {}, ended = {};              // UTC, as ISO 8601 writes it
    double compile_seconds = 0, answer_seconds = 0;  // of the clock, of the processor
    std::string lab = {};                            // the version that graded it

    /// Of equal parts. Their own points are rounded, so that a sum of these would depend on which parts are passed.
    Hundredths points() const;

    /// The points as a share of the most, from 0 to 1.
    double share() const;
    bool passed() const { return outcome == Outcome::pass; }

    /// Whether there was a program that could be asked: there was none where the file is missing, refused or does not
    /// compile, or where the grader failed.
    bool was_asked() const;
};

/// The parts with equal shares of the points, to the hundredth; those that are not passed have none.
std::vector<GradePart> with_equal_points(std::vector<GradePart> parts, Hundredths most);

/// Hundredths as points: "83.33", "100".
std::string points_text(Hundredths points);
inline double points_number(Hundredths points) { return points / 100.0; }

}  // namespace raylab::grading
