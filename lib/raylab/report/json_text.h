#pragma once

#include "raylab/base/output_file.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace raylab {

/// JSON as it stands in files: two spaces a level, a newline at the end, U+FFFD for broken UTF-8, null for NaN.
std::string json_text(const nlohmann::ordered_json& json);

/// Where a program's --json option wants data: "-" is standard output, anything else a file.
void write_json(const std::string& text, const OutputFile& file_or_dash);

}  // namespace raylab
