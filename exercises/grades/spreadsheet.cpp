#include "spreadsheet.h"

#include "part_text.h"

#include "raylab/report/table.h"

#include <string_view>

namespace raylab::grading {

std::string spreadsheet_record(std::vector<std::string> cells) {
    for (auto& cell : cells) {
        cell = safe_text(cell, longest_message);
        if (!cell.empty() && std::string_view("=+-@").find(cell[0]) != std::string_view::npos) cell.insert(0, "'");
    }
    return csv_record(cells);
}

}  // namespace raylab::grading
