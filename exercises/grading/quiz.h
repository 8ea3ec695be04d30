#pragma once

#include "exercise.h"

#include <optional>
#include <string>
#include <vector>

// The questions of a chapter's lesson, as data: their words and answers stand in the lesson, and quiz.toml of the
// chapter's first exercise says what counts as an answer.

namespace raylab::grading {

struct QuizQuestion {
    std::string asks, answer;           // plain text, from the lesson
    std::optional<double> number = {};  // the answer, where it is one
    std::vector<std::string> choices = {};
    std::size_t right = 0;  // index of the choice
    bool is_judged() const { return number || !choices.empty(); }
};

/// A stability case whose outcome for one method is to be guessed before it runs.
struct Prediction {
    std::string stability_case, method;
};

struct Quiz {
    std::vector<QuizQuestion> questions;
    std::vector<Prediction> predictions;
};

/// The quiz of an exercise's chapter. It throws an Error, with file and line, where quiz.toml names a question that the
/// lesson does not ask.
Quiz read_quiz(const Exercise& exercise);

/// Whether what was typed is the answer: a number to two hundredths, a choice by its number from 1 or its first word.
bool is_answer(const QuizQuestion& question, const std::string& typed);

/// A text of a lesson as a terminal shows it: without the marks of emphasis and formulas.
std::string plain_text(const std::string& markdown);

}  // namespace raylab::grading
