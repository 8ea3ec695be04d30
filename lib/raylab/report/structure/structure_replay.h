#pragma once

#include "raylab/experiment/structure/structure_difference_search.h"

#include <filesystem>
#include <string>

namespace raylab {

/// A difference as a JSON file: scene, rays and both answers, with every number exact.
std::string to_json(const StructureDifference& difference);

/// Reads such a file; the Error names what was expected and where.
StructureDifference read_difference(const std::filesystem::path& path);

}  // namespace raylab
