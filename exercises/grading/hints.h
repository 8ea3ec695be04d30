#pragma once

#include "exercise.h"

#include <map>
#include <string>
#include <vector>

namespace raylab::grading {

/// An exercise's hints.toml: texts shown on request, for a typical mistake, and after success.
struct Hints {
    std::vector<std::string> levels;              // the idea, then where to look, then nearly the code
    std::map<std::string, std::string> mistakes;  // indexed by the hint's name
    std::string solution;                         // the file of the reference solution
    std::string look;                             // what the reference does differently
};

/// Reads the hints; throws an Error, with the line, where the file is invalid.
Hints read_hints(const Exercise& exercise);

}  // namespace raylab::grading
