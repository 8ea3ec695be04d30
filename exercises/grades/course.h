#pragma once

#include "exercise.h"
#include "moment.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace raylab::grading {

/// An exercise as a course asks for it.
struct Assignment {
    const Exercise* exercise = nullptr;
    double weight = 1;                    // in the course's total
    std::optional<Moment> deadline = {};  // of a file's own time
    double late = 0;                      // the share of the points that counts after the deadline
};

/// What a folder of submissions is graded for: its course.toml, if it has one.
struct Course {
    std::string title;
    std::vector<Assignment> assignments;
};

/// Reads a course.toml; an Error names file and line, what was expected and what was found.
///
///     title = "Ray tracing"
///     [[exercise]]
///     number = "02"
///     weight = 2                        # of the total; default 1
///     deadline = "2026-11-30 23:59"     # UTC; default: none
///     late = 0.5                        # the share of the points that counts after it; default 0
Course read_course(const std::filesystem::path& file);

}  // namespace raylab::grading
