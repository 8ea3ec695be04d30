#pragma once

#include <string>
#include <vector>

namespace raylab {

/// A table for a terminal, with columns padded to equal width; wide cells are not broken.
std::string text_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows);

/// One CSV record (RFC 4180), quoted where necessary.
std::string csv_record(const std::vector<std::string>& cells);

/// The number of characters that a text shows: code points, not bytes.
std::size_t length_shown(const std::string& text);

/// A number for people, three digits: "0", "0.0123", "12.3", "1 234", "5.6e+07".
std::string number_text(double value);

/// A duration for people: "12.3 ns", "4.56 µs", "1.2 s".
std::string duration_text(double nanoseconds);

}  // namespace raylab
