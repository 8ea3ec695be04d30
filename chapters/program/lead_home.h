#pragma once

#include "exercise.h"

#include <filesystem>

namespace raylab {

/// Draws the traced scene with the student's function, and where it goes wrong the two ray trees of its worst pixel,
/// into a folder; says in words which node of them is the first that differs.
void lead_home(const grading::Exercise& exercise, const std::filesystem::path& folder);

}  // namespace raylab
