#pragma once

#include "exercise.h"

#include <map>
#include <string>
#include <vector>

namespace raylab::grading {

/// An exercise's hints.toml: texts shown on request, for a typical mistake, and after success.
struct Hints {
    std::vector<std::string> levels;              // the idea, then where to look, then nearly the code
    std::map<std::string, std::string> mistakes;  // by the hint's id
    std::map<std::string, std::string> general;   // those for every exercise, by their ids
    std::string solution;                         // the file of the reference solution; empty in a handout
    std::string look;                             // what the reference does differently

    /// The text of a hint; null where there is none of that id.
    const std::string* text(const std::string& id) const&;
    const std::string* text(const std::string& id) const&& = delete;  // it would point into what is gone
};

/// The hints for every exercise (exercises/hints.toml), by their ids.
std::map<std::string, std::string> read_general_hints();

/// Reads the hints; throws an Error, with the line, where the file is invalid.
Hints read_hints(const Exercise& exercise);

}  // namespace raylab::grading
