#pragma once

#include "exercise.h"
#include "grade.h"

#include <filesystem>

namespace raylab::grading {

/// What a student handed in: a file that may be compiled, or the reason why there is none.
struct Submission {
    std::filesystem::path file;
    Submitted submitted;
    std::string fault = {};  // a sentence; empty: the file may be compiled
};

/// Looks at a file, or for the exercise's file in a folder. Links in a folder are not followed, archives are not
/// unpacked: what a student can write into a name never leads the grader elsewhere.
Submission find_submission(const Exercise& exercise, const std::filesystem::path& file_or_folder);

}  // namespace raylab::grading
