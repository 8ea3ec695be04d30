#pragma once

#include "case.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

// What wrong answers have in common, whatever code they come from. Another person's mistake is seldom wrong by the same
// numbers as a known one, but it is wrong in the same way, and in the same cases.

namespace raylab::grading {

/// Some of an answer's numbers, or of a case's, and what they are.
struct Part {
    enum class Kind {
        flag,       // 1 or 0: whether there is an answer, or yes or no
        number,     // one number
        vector,     // three coordinates
        direction,  // three coordinates that are not all 0
        indices,    // whole numbers
    } kind;
    std::string name;  // "t", "the direction"
    std::size_t count = 1;
};

/// A wrong answer beside the library's. Both are the numbers of the case's outputs.
struct WrongAnswer {
    const Case& question;
    std::span<const double> right, given;
};

struct Symptom {
    std::string hint;   // the hint for it, of the exercise's hints.toml or of exercises/hints.toml
    std::string words;  // what is seen, after "In 40 of 41 wrong answers ": "t is where the ray leaves the sphere"
    /// Whether a wrong answer is wrong in this way.
    std::function<bool(const WrongAnswer&)> shows;
    /// The cases in which the mistake cannot stay hidden; empty: it is not known which.
    std::function<bool(const Case&)> where = {};
    /// What the mistake may answer as well, and so may many others ("none"): it speaks neither for it nor against it.
    std::function<bool(const WrongAnswer&)> allows = {};
};

/// The symptoms, of which an answer that is no number supports none any more but those with these hints, which speak of
/// it: that a hit lies at the end of a range, say, is not why it is 0 / 0. Where such an answer showed a symptom, it
/// speaks neither for it nor against it now.
std::vector<Symptom> of_numbers(std::vector<Symptom> symptoms, const std::vector<std::string>& but = {});

/// Whether two numbers agree to seven digits: far fewer than a judge asks for, so that a second, smaller error does not
/// hide how an answer is wrong.
bool agree(double a, double b);

/// Whether vectors agree to seven digits of their length.
bool agree(std::span<const double> a, std::span<const double> b);

}  // namespace raylab::grading
