#pragma once

#include "raylab/base/number_text.h"
#include "raylab/base/wrapped_text.h"

#include <string>
#include <vector>

namespace raylab {

/// The width of a terminal that every table and text is made for, in characters.
constexpr std::size_t terminal_width = 100;

/// A table for a terminal, with columns padded to equal width. Where it would be wider than the terminal, the texts of
/// its widest columns are wrapped.
std::string text_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows);

/// One CSV record (RFC 4180), quoted where necessary.
std::string csv_record(const std::vector<std::string>& cells);

}  // namespace raylab
