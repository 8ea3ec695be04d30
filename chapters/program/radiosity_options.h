#pragma once

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/radiosity/hierarchical_scene.h"
#include "raylab/radiosity/scene_radiosity.h"

#include <map>
#include <string>

// The options of `raylab radiosity`.

namespace raylab {

const CommandLine& radiosity_command_line();

/// The value that an option's word stands for; an Error lists the known words.
template <class Value>
Value one_of(const Arguments& arguments, const std::string& option, const std::map<std::string, Value>& known) {
    const std::string& word = arguments.text(option);
    if (const auto found = known.find(word); found != known.end()) return found->second;
    std::string names;
    for (const auto& [name, value] : known) names += (names.empty() ? "" : ", ") + name;
    throw Error("expected " + option + " to be one of " + names + ", found \"" + word + "\"");
}

/// An option's number, which is over 0.
double positive(const Arguments& arguments, const std::string& option);

/// --tolerance, or what stands for it.
double tolerance_or(double fallback, const Arguments& arguments);

SolverOptions solver_options(const Arguments& arguments);
SceneRadiosityOptions radiosity_options(const Arguments& arguments);

/// Throws an Error that names an option which asks something of the whole matrix: hierarchical radiosity has none.
void refuse_matrix_options(const Arguments& arguments);

SceneHierarchyOptions hierarchy_options(const Arguments& arguments);

}  // namespace raylab
