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

/// The largest seed of an official result: each reader of JSON keeps such numbers exactly.
inline constexpr std::uint64_t largest_seed = (std::uint64_t{1} << 53) - 1;

/// A seed that nobody can foretell, and one that nobody can who has not the course's key: with it, the cases of a
/// submission can be told again from the names of exercise and student.
std::uint64_t fresh_seed();
std::uint64_t seed_by_key(const std::string& key, const std::string& exercise, const std::string& student);

/// A course's key from its file. It throws an Error for a file that cannot be read, or has fewer than 16 bytes.
std::string read_course_key(const std::filesystem::path& file);

}  // namespace raylab::grading
