#pragma once

#include "work.h"

namespace raylab::grading {

/// How one group of cases came out.
struct GroupScore {
    std::string group;
    Case::Kind kind;
    std::size_t right = 0, total = 0;
};

/// One wrong answer, told to a person.
struct WrongCase {
    std::size_t index;  // among all cases, from 0
    std::string group, story, expected, got;
};

/// The verdict on a set of answers.
struct Verdict {
    std::vector<GroupScore> groups;          // graded ones first, each in the order the cases came
    std::size_t right = 0, total = 0;        // graded cases only
    std::optional<WrongCase> first_wrong;    // of the graded cases
    std::optional<std::string> hint;         // of the known mistake whose answers, or whose work, these look like
    std::vector<WorkScore> work = {};        // task by task, where it was counted
    std::string work_ended = {};             // what ended the process before all work was counted; empty: nothing did

    bool answers_right() const { return total > 0 && right == total; }
    bool passed() const { return answers_right() && work_ended.empty() && std::ranges::all_of(work, &WorkScore::passed); }
    /// Right in every answer and on every ray, and yet not passed.
    bool works_too_much() const {
        const auto strayed = [](const WorkScore& score) { return score.strayed > 0; };
        return answers_right() && !passed() && std::ranges::none_of(work, strayed);
    }
};

/// The answers of a function to all cases, one after the other.
std::vector<double> answers_of(const Exercise& exercise, const Answer& answer, const std::vector<Case>& cases);

/// Judges answers (cases.size() x exercise.outputs doubles; fewer: the rest counts as unanswered).
Verdict judge(const Exercise& exercise, const std::vector<Case>& cases, std::span<const double> answers);

/// The verdict with the work that was counted. Where the answers are right and the work is too much, the hint is that of a
/// known mistake of which both can be said, task by task.
Verdict with_work(Verdict verdict, const Exercise& exercise, const std::vector<Case>& cases, std::vector<WorkScore> work);

/// The hint of the known mistake that explains wrong answers best: it gives the student's very answer in most of the cases the
/// student got wrong, and is wrong in as few others as possible. Absent: no mistake explains half of them.
std::optional<std::string> matching_hint(const Exercise& exercise, const std::vector<Case>& cases,
                                            std::span<const double> answers);

}  // namespace raylab::grading
