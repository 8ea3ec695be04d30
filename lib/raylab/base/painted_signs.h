#pragma once

#include <string>
#include <string_view>

namespace raylab {

/// Text for a terminal in which each sign has a colour, together with the words behind it, up to two blanks or the end
/// of the line: "✓" is green, "✗" red, "‼" white on red. The signs say the same without colour.
std::string painted_signs(std::string_view text);

/// Whether standard output shows colours: it is a terminal, and the environment sets neither NO_COLOR (no-color.org)
/// nor TERM=dumb.
bool standard_output_shows_colors();

}  // namespace raylab
