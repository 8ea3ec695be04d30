#pragma once

#include "exercise.h"

// The work that a function causes, compared with the reference's. The student's process traces a task's rays with its
// function and sends each answer; the judge traces the same rays with these answers as the function's, and counts for
// itself. So nothing that the process claims about its own work is believed, and false answers count as those of a
// function that gives them.

namespace raylab::grading {

inline constexpr double work_allowed = 1.1;  // times the reference's, because right functions round differently
// Times the reference's calls; a function that is called more often is stopped.
inline constexpr double work_watched = 10;

/// The result of a function for one task.
struct WorkScore {
    std::string rays, unit;
    double reference = 0, allowed = 0;  // for each ray
    std::optional<double> yours = {};   // for each ray; absent where it was stopped
    std::size_t strayed = 0;            // rays that hit something else than the reference's: their work proves nothing
    std::size_t total = 0;              // number of rays
    std::optional<WrongCase> astray =
        {};  // where rays stray, the first question on their way that was answered wrongly

    bool passed() const { return yours && *yours <= allowed && strayed == 0; }
};

/// The most calls that each of the exercise's tasks may make.
std::vector<double> max_questions(const Exercise& exercise);

/// The scores of a function in this process.
std::vector<WorkScore> work_scores(const Exercise& exercise, const Answer& answer);

/// The scores of answers from another process: for one task after the other, in the order of the calls.
std::vector<WorkScore> work_scores(const Exercise& exercise, std::span<const double> said);

}  // namespace raylab::grading
