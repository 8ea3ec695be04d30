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

/// The reason not to look at what was handed in, if it is a symbolic link: that may lead to a reference, or to what
/// only the grader may read. Empty where it is none; the folders above it may be links.
std::string fault_of_link(const std::filesystem::path& handed_in);

/// Looks at a file, or for the exercise's file in a folder. Neither it nor what is in it is followed where it is a
/// link, archives are not unpacked: what a student can write into a name never leads the grader elsewhere.
Submission find_submission(const Exercise& exercise, const std::filesystem::path& file_or_folder);

}  // namespace raylab::grading
