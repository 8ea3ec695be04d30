#pragma once

#include "hints.h"
#include "judging.h"
#include "student.h"

#include <string>

namespace raylab::grading {

/// The verdict for a person: groups, the first wrong case told as a story, what is probably wrong.
std::string to_text(const Exercise& exercise, const Verdict& verdict, const Hints& hints);

/// Why there is nothing to judge: not written yet, a crash, an endless loop.
std::string to_text(const Exercise& exercise, const Answers& answers);

/// The same for machines: {"exercise", "verdict", "right", "total", "groups", "work", "work_ended",
/// "first_wrong", "hint"}; the verdict is pass, wrong, or too_much_work where all is right and work alone fails.
std::string to_json(const Exercise& exercise, const Verdict& verdict);

/// {"exercise", "verdict": "unfinished" | "crash" | ..., "reason"}.
std::string to_json(const Exercise& exercise, const Answers& answers);

}  // namespace raylab::grading
