#pragma once

#include "raylab/base/output_place.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab {

/// A complete output that is not yet where it belongs.
struct CompleteOutput {
    OutputPlace place;
    std::filesystem::path file = {};  // what is renamed where it replaces
    std::string bytes = {};           // what is written where it is written through
};

/// Writes through first, then makes missing folders and renames, which an interrupt waits for. A reader that has closed
/// its end of a pipe is no Error: the signal of it comes when all is in place.
void put_in_place(const std::vector<CompleteOutput>& outputs);

}  // namespace raylab
