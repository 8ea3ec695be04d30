#pragma once

#include "exercise.h"
#include "quiz_seal.h"

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
    // In a handout, which tells no answer: the seal of the number or of the choice, instead of either.
    std::optional<QuizSeal> seal = {};
    bool is_judged() const { return number || !choices.empty() || seal; }
};

/// A stability case whose outcome for one method is to be guessed before it runs.
struct Prediction {
    std::string stability_case, method;
};

/// Methods of a chart, to be put in order before they are measured: the most exact first.
struct OrderToPredict {
    std::string chart, workload;
    std::string knob = {};             // of methods that are measured with several
    std::vector<std::string> methods;  // "Phong, double"
};

struct Quiz {
    std::vector<QuizQuestion> questions;
    std::vector<Prediction> predictions;
    std::vector<OrderToPredict> orders;
};

/// The quiz of an exercise's chapter. It throws an Error, with file and line, where quiz.toml names a question that the
/// lesson does not ask.
Quiz read_quiz(const Exercise& exercise);

/// The same of these texts: quiz.toml, named `file` in errors, and the lesson.
Quiz quiz_in(const std::string& answers, const std::string& file, const std::string& lesson);

/// Whether what was typed is the answer: a number to two hundredths, a choice by its number from 1 or its first word.
bool is_answer(const QuizQuestion& question, const std::string& typed);

/// Whether what was typed, the methods' numbers from 1 on, puts these errors in order, the least first. Methods whose
/// errors are equal may stand in any order.
bool is_order(const std::vector<double>& errors, const std::string& typed);

/// A text of a lesson as a terminal shows it: without the marks of emphasis and formulas.
std::string plain_text(const std::string& markdown);

}  // namespace raylab::grading
