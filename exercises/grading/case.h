#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace raylab::grading {

/// One call of a student's function, as the doubles of its arguments.
struct Case {
    enum class Kind {
        graded,       // keeps a margin from every decision boundary that any correct double method respects
        adversarial,  // shown ("how sturdy is yours?"), but never counted
    };
    std::string group;  // "inside start"
    Kind kind = Kind::graded;
    std::vector<double> input;
};

/// The judge's result for one answer.
struct Judgement {
    enum class Outcome { right, wrong, nonfinite } outcome = Outcome::wrong;
    std::string expected, got;  // in words: "a hit at t = 1.25", "no hit"
};

/// One wrong answer, explained for a person.
struct WrongCase {
    std::size_t index;  // index among all cases, or questions of a task
    std::string group, story, expected, got;
    Case question = {};
    std::vector<double> answer = {};
};

}  // namespace raylab::grading
