#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

// The seeds of official results, from which their cases follow.

namespace raylab::grading {

/// A seed that nobody can foretell, at most largest_seed (raylab/base/common_options.h).
std::uint64_t fresh_seed();

/// A seed that nobody can foretell who has not the course's key: with it, the cases of a submission can be told again
/// from the names of exercise and student.
std::uint64_t seed_by_key(const std::string& key, const std::string& exercise, const std::string& student);

/// A course's key from its file. It throws an Error for a file that cannot be read, has fewer than 16 bytes, which
/// could be guessed, or more than 4096, which is no key.
std::string read_course_key(const std::filesystem::path& file);

}  // namespace raylab::grading
