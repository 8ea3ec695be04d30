#pragma once

#include "student.h"
#include "verdict_text.h"

namespace raylab::grading {

/// What a compiled function was asked, what it answered, and what that is worth.
struct JudgedAnswers {
    std::vector<Case> cases;
    Answers answers;    // of the process that ended before its time; where none did, the answers to the cases
    Verdict verdict;    // what was not answered counts as wrong
    std::string ended;  // why there is no more to judge, for a person; empty where everything was answered
};

/// Asks the function all cases of the seed, once more from last to first, and for the work that it causes where the
/// exercise counts that, each in a process of its own, and judges the answers.
JudgedAnswers ask(const Exercise& exercise, const Workplace& workplace, std::uint64_t seed);

/// The arguments of all cases, one after the other.
std::vector<double> inputs_of(const std::vector<Case>& cases);

}  // namespace raylab::grading
