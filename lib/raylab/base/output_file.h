#pragma once

#include <concepts>
#include <filesystem>

namespace raylab {

class Outputs;

/// Where a writer's file goes: a path, at once; or one of a command's Outputs, when all of them are complete.
struct OutputFile {
    template <std::convertible_to<std::filesystem::path> Path>
    OutputFile(const Path& file) : path(file) {}
    OutputFile(const std::filesystem::path& file, Outputs& outputs) : path(file), together(&outputs) {}

    std::filesystem::path path;   // as the user named it; "-" is standard output
    Outputs* together = nullptr;  // null: this file alone
};

}  // namespace raylab
