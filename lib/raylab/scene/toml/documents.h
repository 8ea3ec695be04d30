#pragma once

#include "raylab/scene/toml/value.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raylab::toml_file {

/// One file of a scene, checked against the scene format.
struct Document {
    std::filesystem::path path;
    std::string file;  // as errors name it
    Value root;
};

/// The scene file and the files it includes, each once, a file behind those it includes. Error for a cycle, for
/// includes nested too deep and for too much text in all.
std::vector<Document> load_documents(std::string_view text, const std::filesystem::path& path);

}  // namespace raylab::toml_file
