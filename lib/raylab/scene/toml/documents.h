#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/scene/toml/value.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raylab::toml_file {

/// One file of a scene, checked against the scene format.
struct Document {
    std::filesystem::path path;
    std::string file;  // the name that errors use
    Value root;
};

/// Loads the scene file and the files it includes, each once, with a file after those that it includes. It throws an
/// Error for a cycle, for includes nested too deep, for too much text in all, and before it allocates more memory than
/// the limit.
std::vector<Document> load_documents(std::string_view text, const std::filesystem::path& path,
                                     const MemoryLimit& limit);

}  // namespace raylab::toml_file
