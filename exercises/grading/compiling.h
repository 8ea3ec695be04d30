#pragma once

#include "workplace.h"

namespace raylab::grading {

/// The result of compiling a student's file.
struct Compiled {
    bool succeeded = false;
    bool refused = false;  // it is C++, but no answer
    double seconds = 0;
    // The compiler's messages, with the student's file and lines, or why the file is refused; warnings, where it is
    // not.
    std::string diagnostics;
};

/// Compiles the file in the workplace, looks at what it includes, defines and calls, and links the exercise's program.
/// It throws an Error where there is no such file.
Compiled compile(const Exercise& exercise, const Workplace& workplace, const std::filesystem::path& file);

/// Links the tracer, or the chapter's program, with the function as it was compiled. They throw an Error where that
/// fails.
void link_tracer(const Exercise& exercise, const Workplace& workplace);
void link_chapter(const Exercise& exercise, const Workplace& workplace);

}  // namespace raylab::grading
