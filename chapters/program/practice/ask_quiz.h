#pragma once

#include "exercise.h"

#include "raylab/base/program.h"

namespace raylab {

/// Asks a chapter's questions, and for guesses of what its stability cases and charts will say, on standard input;
/// judges what is a number or a choice, and tells the answer. Negative where an answer was wrong, or the input ended.
ExitCode ask_quiz(const grading::Exercise& exercise);

}  // namespace raylab
