#pragma once

#include "raylab/base/output_file.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace raylab {

/// JSON text for a file: indented by two spaces, with a newline at the end, U+FFFD for invalid UTF-8, null for NaN.
std::string json_text(const nlohmann::ordered_json& json);

/// Writes the text of a program's --json option: "-" is standard output, anything else a file.
void write_json(const std::string& text, const OutputFile& file_or_dash);

}  // namespace raylab
