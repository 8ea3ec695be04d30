#pragma once

#include "hints.h"
#include "judging.h"
#include "student.h"

#include <string>

namespace raylab::grading {

/// The verdict for a person: groups, the first wrong case told as a story, and the probable mistake.
std::string to_text(const Exercise& exercise, const Verdict& verdict, const Hints& hints);

/// The reason why there is nothing to judge: not written yet, a crash, an endless loop.
std::string to_text(const Exercise& exercise, const Answers& answers);

/// The verdict as JSON: {"exercise", "verdict", "right", "total", "groups", "work", "work_ended", "first_wrong",
/// "hint"}; the verdict is pass, wrong, or too_much_work where all is right and only the work fails.
std::string to_json(const Exercise& exercise, const Verdict& verdict);

/// The reason as JSON: {"exercise", "verdict": "unfinished" | "crash" | ..., "reason"}.
std::string to_json(const Exercise& exercise, const Answers& answers);

}  // namespace raylab::grading
