#pragma once

#include "workplace.h"

#include "raylab/base/outputs.h"

#include <string>

namespace raylab {

/// Draws the traced scene with the student's function into a folder and, where it is wrong, the two ray trees of its
/// worst pixel. The text that is returned names their first node that differs.
std::string lead_home(const grading::Exercise& exercise, const grading::Workplace& workplace,
                      const StagedFolder& folder);

}  // namespace raylab
