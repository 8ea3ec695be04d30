#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/tracer/whitted/ray_tree.h"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

// Ray trees as JSON: `raylab tree` writes them, and they are read again bit for bit.

namespace raylab {

/// {"raylab": "ray tree", "pixel": [r, g, b], "nodes": [...]}; absent values and an infinite t are null.
nlohmann::ordered_json to_json(const RayTree& tree);

/// Reads a ray tree from JSON. It throws an Error, naming `source` and the place inside, for whatever is not a ray tree
/// with parents before children, and for more memory than the limit.
RayTree ray_tree_from_json(std::string_view text, const std::string& source, const MemoryLimit& limit = {});

/// Reads a ray tree from a JSON file.
RayTree read_ray_tree(const std::filesystem::path& path, const MemoryLimit& limit = {});

}  // namespace raylab
