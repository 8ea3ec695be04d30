#pragma once

#include <cstddef>
#include <string>

// Handouts judge a quiz and tell no answer: quiz.toml has hashes there. Whoever wants to can try every choice, but that
// is what answering is; nobody reads an answer by chance.

namespace raylab::grading {

struct QuizSeal {
    std::string question;  // its beginning, so that equal answers have unequal hashes
    std::string hash;
};

/// Whether it is the seal of this number, to two hundredths and a half, or of a choice by its index.
bool seals_number(const QuizSeal& seal, double number);
bool seals_choice(const QuizSeal& seal, std::size_t choice);

/// quiz.toml with hashes for answers, and no predictions: a handout has no stability cases to run, and no charts.
std::string sealed_quiz(const std::string& answers);

/// A lesson without the answers that are folded under its questions.
std::string without_answers(const std::string& lesson);

}  // namespace raylab::grading
