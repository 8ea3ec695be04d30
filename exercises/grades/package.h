#pragma once

#include "exercise.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab::grading {

/// The machines that a package can be made for: the folders of exercises/package.
std::vector<std::string> package_kinds();

/// Fills a folder with what such a machine installs to grade one exercise: its scripts, and a handout to grade with. It
/// throws an Error for a kind that is none.
void write_package(const Exercise& exercise, const std::string& kind, const std::filesystem::path& folder);

}  // namespace raylab::grading
