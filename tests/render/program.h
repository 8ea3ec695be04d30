#pragma once

#include "raylab/base/process.h"
#include "raylab/image/image.h"

#include <filesystem>
#include <string>
#include <vector>

// Runs `raylab render` and `raylab merge` from outside, on small scenes.

namespace raylab::test {

/// A folder for what these tests write.
std::filesystem::path written(const std::string& name);

/// An area light, a glossy floor and a lens: every kind of number is used but time.
std::string spread_scene();

/// Runs raylab with these words.
ProcessResult ran(const std::vector<std::string>& words);

/// Draws the scene with these options; the picture's file. It must succeed.
std::filesystem::path drawn(const std::string& name, std::vector<std::string> options);

/// Whether all channels of all pixels are the same floats.
bool same_bits(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace raylab::test
