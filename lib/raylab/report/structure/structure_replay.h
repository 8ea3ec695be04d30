#pragma once

#include "raylab/report/structure/structure_difference_search.h"

#include <filesystem>
#include <string>

namespace raylab {

/// A difference as a file: scene, rays and both answers, every number exact.
std::string to_json(const StructureDifference& difference);

/// Reads it back; Error names what was expected where.
StructureDifference read_difference(const std::filesystem::path& path);

}  // namespace raylab
