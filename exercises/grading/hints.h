#pragma once

#include "exercise.h"

#include <map>
#include <string>
#include <vector>

namespace raylab::grading {

/// An exercise's hints.toml: what is said on request, to a typical mistake, and after success.
struct Hints {
    std::vector<std::string> levels;              // the idea, where to look, nearly the code
    std::map<std::string, std::string> mistakes;  // by the hint's name
    std::string solution;                         // the reference's file
    std::string look;                             // what it does differently
};

/// Error, with the line, where the file is not as it should be.
Hints read_hints(const Exercise& exercise);

}  // namespace raylab::grading
