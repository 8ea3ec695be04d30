#pragma once

#include <string>
#include <string_view>

// Names come from files and command lines. They must neither control a terminal nor break a line.

namespace raylab {

/// The text with everything unprintable escaped: \u{1b} for a character (C0, DEL, C1, line separators and characters
/// that change the direction of writing), \xff for a byte that is not UTF-8.
std::string printable(std::string_view text);

/// The same for text of several lines: newlines and tabs are kept.
std::string printable_lines(std::string_view text);

/// Another program's output as a part of one line: each run of blanks and newlines becomes one blank.
std::string on_one_line(std::string_view text);

}  // namespace raylab
