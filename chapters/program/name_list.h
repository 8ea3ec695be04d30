#pragma once

#include "raylab/base/outputs.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// A question or a stability case, and the chapter that has it.
struct ListedName {
    std::string name, chapter;
};

/// Prints a line for each name, and writes [{name, chapter}] to `json`, one of the outputs; only that, if it is "-".
void list_names(const std::vector<ListedName>& names, const std::optional<std::string>& json, Outputs& outputs);

}  // namespace raylab
