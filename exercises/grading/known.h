#pragma once

#include "exercise.h"

#include <string>
#include <vector>

namespace raylab::grading {

/// One of the files in mistakes/ or right/, compiled under a name of its own.
template <class Function>
struct KnownFunction {
    std::string name;  // the file's
    std::string hint;  // of the first line "// hint: ..."; right answers have none
    Function function;
};

/// These functions behind the exercise's way of passing arguments.
template <class Function, class Adapter>
std::vector<KnownAnswer> known_answers(const std::vector<KnownFunction<Function>>& functions, const Adapter& adapter) {
    std::vector<KnownAnswer> known;
    for (const auto& [name, hint, function] : functions)
        known.push_back({name, hint, [function, adapter](std::span<const double> input, std::span<double> output) {
                             adapter(function, input, output);
                         }});
    return known;
}

}  // namespace raylab::grading
