#pragma once

#include "exercise.h"

#include <filesystem>
#include <string>

// To read the headers takes four fifths of compiling an answer, and they are the same for a whole class. So the header
// that declares the exercise's function is compiled once. GCC takes the compiled one where an answer includes this
// header first, as the stub does; otherwise, and with another compiler, it reads headers as ever. The object is the
// same.

namespace raylab::grading {

/// The header that declares the exercise's function: "raylab/geometry/nearest_sphere_hit.h".
std::string declaring_header(const Exercise& exercise);

/// Compiles it into the folder, by the words with which answers are compiled. Where that fails there is none.
void prepare_header(const Exercise& exercise, const std::filesystem::path& folder);

/// Puts the one from the folder beside the copied header. Nothing happens where the folder has none, or where files
/// cannot be linked there: a copy of 50 megabytes would take away what is gained.
void share_prepared_header(const Exercise& exercise, const std::filesystem::path& folder,
                           const std::filesystem::path& headers);

}  // namespace raylab::grading
