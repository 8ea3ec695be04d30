#pragma once

#include <filesystem>
#include <string>

namespace raylab {

/// An exercise in its lesson: its task, the file to write, and the command that checks it. `title` is HTML.
std::string exercise_html(const std::filesystem::path& folder, const std::string& title);

}  // namespace raylab
