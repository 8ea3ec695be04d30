#pragma once

#include "exercise.h"
#include "grade.h"

#include <filesystem>

namespace raylab::grading {

/// Under what a submission is graded.
struct Terms {
    std::uint64_t seed = 0;  // of the cases
    Isolation isolation;
    Hundredths most = 10000;              // for an answer that passes
    std::filesystem::path prepared = {};  // a folder with headers that were compiled before; empty: there is none
};

/// Compiles the submission, asks it, judges it. Each group of graded cases is a part, and so is each task whose work is
/// counted; all parts have the same points, and a part has them if all of it is right: guessing "no hit" would be right
/// in half of most groups. A part that one answer for all cases would pass, "no hit" again, counts only with one that
/// it would not. It throws an Error where the grader itself fails.
Grade official_grade(const Exercise& exercise, const std::filesystem::path& file_or_folder, const Terms& terms);

/// The hash of the exercise's cases of this seed, with the reference's answers to them.
std::string cases_sha256(const Exercise& exercise, const std::vector<Case>& cases);

}  // namespace raylab::grading
