#pragma once

#include "exercise.h"

#include <string>
#include <vector>

namespace raylab::grading {

/// One of the files in mistakes/ or right/, compiled under a name of its own.
template <class Function>
struct KnownFunction {
    std::string name;  // of the file
    std::string hint;  // from its first line "// hint: ..."; right answers have none
    Function function;
};

/// What the build knows of an exercise: its names, the library's function, and the files in mistakes/ and right/.
template <class Function>
struct Slot {
    std::string folder, name, chapter;
    bool traced;  // whether the build has a tracer with the student's function
    Function reference;
    std::vector<KnownFunction<Function>> mistakes, right;
};

/// Wraps these functions in the exercise's way of passing arguments.
template <class Function, class Adapter>
std::vector<KnownAnswer> known_answers(const std::vector<KnownFunction<Function>>& functions, const Adapter& adapter) {
    std::vector<KnownAnswer> known;
    for (const auto& [name, hint, function] : functions)
        known.push_back({name, hint, [function, adapter](std::span<const double> input, std::span<double> output) {
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
