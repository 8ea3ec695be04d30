#pragma once

#include "exercise.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raylab::grading {

/// One of the files in mistakes/ or right/, compiled under a name of its own. All of them stand in the program as they
/// are: nothing is made of them before an exercise is asked for.
template <class Function>
struct KnownFunction {
    std::string_view name;  // of the file
    std::string_view hint;  // from its first line "// hint: ..."; right answers have none
    Function function;
};

/// What the build knows of an exercise: its names, the library's function, and the files in mistakes/ and right/.
template <class Function>
struct Slot {
    std::string_view folder, name, chapter;
    bool traced;  // whether the build has a tracer with the student's function
    Function reference;
    std::span<const KnownFunction<Function>> mistakes, right;
};

/// Wraps these functions in the exercise's way of passing arguments.
template <class Function, class Adapter>
std::vector<KnownAnswer> known_answers(std::span<const KnownFunction<Function>> functions, const Adapter& adapter) {
    std::vector<KnownAnswer> known;
    for (const auto& [name, hint, function] : functions)
        known.push_back({std::string(name), std::string(hint),
                         [function, adapter](std::span<const double> input, std::span<double> output) {
                             adapter(function, input, output);
                         }});
    return known;
}

/// The exercise, completed with what the build knows of it; `answer` is its way of passing arguments.
template <class Function, class Adapter>
Exercise exercise_on(const Slot<Function>& slot, const Adapter& answer, Exercise exercise) {
    exercise.folder = slot.folder;
    exercise.slot = slot.name;
    exercise.chapter = slot.chapter;
    exercise.traced = slot.traced;
    exercise.reference = [function = slot.reference, answer](std::span<const double> input, std::span<double> output) {
        answer(function, input, output);
    };
    exercise.mistakes = known_answers(slot.mistakes, answer);
    exercise.right = known_answers(slot.right, answer);
    return exercise;
}

}  // namespace raylab::grading
