#pragma once

#include "work.h"

namespace raylab::grading {

/// The result for one group of cases.
struct GroupScore {
    std::string group;
    Case::Kind kind;
    std::size_t right = 0, total = 0;
};

/// The verdict on a set of answers.
struct Verdict {
    std::vector<GroupScore> groups;        // graded ones first, each kind in the order of the cases
    std::size_t right = 0, total = 0;      // graded cases only
    std::optional<WrongCase> first_wrong;  // of the graded cases
    std::optional<std::string> hint;       // the id of the one that these answers, or this work, support
    std::string evidence = {};             // for the hint: sentences
    std::vector<WorkScore> work = {};      // for each task whose work was counted
    // What ended the process before all work was counted; empty where nothing did.
    std::string work_ended = {};

    bool answers_right() const { return total > 0 && right == total; }
    bool passed() const {
        return answers_right() && work_ended.empty() && std::ranges::all_of(work, &WorkScore::passed);
    }
    /// Whether every answer and every ray is right, but the work exceeds what is allowed.
    bool works_too_much() const {
        const auto strayed = [](const WorkScore& score) { return score.strayed > 0; };
        return answers_right() && !passed() && std::ranges::none_of(work, strayed);
    }
};

/// The answers of a function to all cases, one after the other.
std::vector<double> answers_of(const Exercise& exercise, const Answer& answer, const std::vector<Case>& cases);

/// Judges answers (cases.size() x exercise.outputs doubles; if there are fewer, the rest counts as unanswered). Where
/// the same cases were asked a second time, from last to first in another process, a case is right if both answers to
/// it are, and agree; `again` has those answers in the order of the cases.
Verdict judge(const Exercise& exercise, const std::vector<Case>& cases, std::span<const double> answers,
              std::span<const double> again = {});

/// The verdict with the work that was counted. Where the answers are right and the work is too much, the hint is that
/// of a known mistake that is right, too, and whose work is equally too much in each task.
Verdict with_work(Verdict verdict, const Exercise& exercise, const std::vector<Case>& cases,
                  std::vector<WorkScore> work);

/// The verdict on a function in this process: on its answers and, where these are right and work counts, on that.
Verdict verdict_on(const Exercise& exercise, const std::vector<Case>& cases, const Answer& answer);

}  // namespace raylab::grading
