#pragma once

#include "grade.h"

#include <cstddef>
#include <string>

// What all formats say in the same words.

namespace raylab::grading {

inline constexpr std::size_t longest_message = 4000;  // bytes that each of the graders shows
inline constexpr std::size_t longest_output = 8000;

/// The text as valid UTF-8 without control characters (they are shown escaped) and of at most this many bytes, cut
/// between two characters.
std::string safe_text(const std::string& text, std::size_t longest);

/// What became of the whole submission: the summary, compiler's messages, how it ended, the first wrong answer, the
/// hint, what it printed.
std::string whole_text(const Grade& grade);

/// What is said beside a part that is not passed: how many cases are right, and the first wrong answer if it is there.
std::string part_text(const Grade& grade, const GradePart& part);

/// The same, for formats that have no place for the whole submission: beside the first part that is not passed stands
/// what became of all of it.
std::string part_text_with_whole(const Grade& grade, const GradePart& part);

/// "seed 7, isolation level 3 (...), compiled in 0.6 s, answered in 0.01 s".
std::string conditions_text(const Grade& grade);

}  // namespace raylab::grading
