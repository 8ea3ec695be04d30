#pragma once

#include <string>
#include <string_view>

// Names come from files and command lines: what they hold must neither steer a terminal nor break a line.

namespace raylab {

/// The text with all that is not printable as an escape: \u{1b} for a character (C0, DEL, C1, line separators and what
/// turns the direction of writing), \xff for a byte that is not UTF-8.
std::string printable(std::string_view text);

/// The same for text of several lines: its newlines and tabs stay.
std::string printable_lines(std::string_view text);

/// What another program printed, as a part of one line: each run of blanks and newlines becomes a blank.
std::string on_one_line(std::string_view text);

}  // namespace raylab
