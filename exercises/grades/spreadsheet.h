#pragma once

#include <string>
#include <vector>

namespace raylab::grading {

/// A CSV record of texts that others wrote: what begins like a formula is none in a spreadsheet, and nothing in a text
/// ends its field.
std::string spreadsheet_record(std::vector<std::string> cells);

}  // namespace raylab::grading
