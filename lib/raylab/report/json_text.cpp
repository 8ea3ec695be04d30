#include "raylab/report/json_text.h"

#include "raylab/base/file.h"

#include <nlohmann/json.hpp>

namespace raylab {

std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_json(const std::string& text, const OutputFile& file_or_dash) { write_file(file_or_dash, text); }

}  // namespace raylab
