#pragma once

#include "grade.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

// The lab's own form of a result, "raylab.result/1", from which all others can be made.

namespace raylab::grading {

nlohmann::ordered_json to_json(const Grade& grade);

/// Reads what to_json() gave. It throws an Error, with `source` and the place in it, for anything else.
Grade grade_from_json(const nlohmann::ordered_json& json, const std::string& source);

}  // namespace raylab::grading
