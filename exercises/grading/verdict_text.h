#pragma once

#include "hints.h"
#include "judging.h"
#include "student.h"

#include <string>

namespace raylab::grading {

/// The verdict for a person: groups, the first wrong case told as a story, and the probable mistake.
std::string to_text(const Exercise& exercise, const Verdict& verdict, const Hints& hints);

/// What a student's function printed, so that no line of it can be taken for one of the check's.
std::string quoted(const std::string& printed);

/// Under what a verdict came about.
struct Conditions {
    std::uint64_t seed;
    Isolation isolation;
};

/// The reason why there is nothing to judge: not written yet, a crash, an endless loop.
std::string to_text(const Exercise& exercise, const Answers& answers);

/// The same where it ended while it answered these cases: at which of them, and what the answers before were worth.
std::string to_text(const Exercise& exercise, const Answers& answers, const std::vector<Case>& cases);

/// The verdict as JSON: {"exercise", "verdict", "right", "total", "groups", "work", "work_ended", "first_wrong",
/// "hint_id", "evidence", "seed", "isolation"}; the verdict is pass, wrong, or too_much_work where all is right and
/// only the work fails.
std::string to_json(const Exercise& exercise, const Verdict& verdict, const Conditions& conditions);

/// The reason as JSON: {"exercise", "verdict": "unfinished" | "crash" | ..., "reason", "answered", "seed",
/// "isolation"}.
std::string to_json(const Exercise& exercise, const Answers& answers, const Conditions& conditions);

}  // namespace raylab::grading
