#pragma once

#include "exercise.h"

// How much work a function causes, beside the reference. The student's process traces a task's rays with its function
// and says each answer; the judge traces the same rays, takes what was said for the function's answers, and counts for
// itself. So nothing is believed that the process may say of its own work: false answers are worth what a function is
// worth that gives them.

namespace raylab::grading {

inline constexpr double work_allowed = 1.1;  // times the reference's: right functions round differently
inline constexpr double work_watched = 10;   // times the reference's questions: who asks more is stopped

/// How a function did one task.
struct WorkScore {
    std::string rays, unit;
    double reference = 0, allowed = 0;  // a ray
    std::optional<double> yours = {};   // a ray; absent: stopped
    std::size_t strayed = 0;            // rays that meet something else than the reference's: their work proves nothing
    std::size_t total = 0;              // rays

    bool passed() const { return yours && *yours <= allowed && strayed == 0; }
};

/// How many questions each of the exercise's tasks may ask, at most.
std::vector<double> most_questions(const Exercise& exercise);

/// The scores of a function in this process.
std::vector<WorkScore> work_scores(const Exercise& exercise, const Answer& answer);

/// The scores of answers said elsewhere: of one task after the other, in the order in which they were asked for.
std::vector<WorkScore> work_scores(const Exercise& exercise, std::span<const double> said);

}  // namespace raylab::grading
