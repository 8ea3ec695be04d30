#pragma once

#include "course.h"
#include "grade.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// A whole class: each submission is graded by a process of its own, which writes one file. So what crashes the grader
// costs one result, which says so; a run that was stopped goes on where it was; and parts of it can run on several
// machines.

namespace raylab::grading {

/// One student's file or folder for one exercise.
struct HandedIn {
    std::string student;
    std::string exercise;  // its folder
    std::filesystem::path path;
};

/// The submissions in a folder, in order: each entry is a student's, a folder or, for one exercise, a file; of
/// another, such as a link, find_submission() tells what is wrong. Hidden entries and course.toml are none. It throws
/// an Error where there is none, and for names that cannot be told apart or are too long to be those of results.
std::vector<HandedIn> handed_in(const std::filesystem::path& folder, const Course& course);

/// A result is STUDENT.json.
constexpr const char* result_extension = ".json";

/// How a class is graded.
struct ClassTerms {
    std::filesystem::path report;       // results go to REPORT/results/EXERCISE/STUDENT.json
    std::vector<std::string> words;     // for each `raylab grade`: --isolation
    Hundredths most = 10000;            // for an answer that passes
    std::optional<std::string> key;     // for seeds, and for pseudonyms where those are asked for
    std::optional<std::uint64_t> seed;  // the same for all
    bool pseudonyms = false;
    bool regrade = false;  // results whose cases have changed since, by the same seed
    int threads = 0;       // submissions at a time; 0: as many as cores
};

/// What a run did.
struct ClassRun {
    std::size_t graded = 0, kept = 0, internal = 0;
    std::size_t other_cases = 0;            // of those kept: made with cases that have changed since
    std::vector<std::string> changes = {};  // of points, where it graded again
};

ClassRun grade_class(const std::vector<HandedIn>& submissions, const ClassTerms& terms);

/// The name under which a student's results are kept.
std::string name_in_report(const std::string& student, const ClassTerms& terms);

}  // namespace raylab::grading
