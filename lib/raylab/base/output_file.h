#pragma once

#include <concepts>
#include <filesystem>

namespace raylab {

class Outputs;

/// The destination of a writer's file: a path, which is written at once, or one of a command's Outputs, which are
/// written when all of them are complete.
struct OutputFile {
    template <std::convertible_to<std::filesystem::path> Path>
    OutputFile(const Path& file) : path(file) {}
    OutputFile(const std::filesystem::path& file, Outputs& outputs) : path(file), together(&outputs) {}

    std::filesystem::path path;   // as the user wrote it; "-" is standard output
    Outputs* together = nullptr;  // null: this file alone
};

}  // namespace raylab
