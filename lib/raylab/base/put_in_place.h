#pragma once

#include "raylab/base/output_place.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab {

/// A complete output that is not yet at its place.
struct CompleteOutput {
    OutputPlace place;
    std::filesystem::path file = {};  // the file to be renamed, for an output that replaces
    std::string bytes = {};           // the bytes to be written, for an output that is written directly
};

/// Writes the outputs that are written directly, then creates missing folders and renames files; an interrupt waits
/// meanwhile. A reader that has closed its end of a pipe is no Error: its signal is delivered when all is in place.
void put_in_place(const std::vector<CompleteOutput>& outputs);

}  // namespace raylab
