#pragma once

#include "exercise.h"

#include "raylab/base/outputs.h"

#include <string>

namespace raylab {

/// Draws the traced scene with the student's function, and where it goes wrong the two ray trees of its worst pixel,
/// into a folder; the words say which node of them is the first that differs.
std::string lead_home(const grading::Exercise& exercise, const StagedFolder& folder);

}  // namespace raylab
