#pragma once

#include <filesystem>

namespace raylab::grading {

/// Puts into a handout the lessons of the exercises' chapters, without answers and without links to what the handout
/// does not hold, with their pictures; and the scenes of all chapters, which commands and other scenes name. What
/// lessons link to has to be there before.
void write_lessons(const std::filesystem::path& handout);

}  // namespace raylab::grading
