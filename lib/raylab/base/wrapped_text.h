#pragma once

#include <cstddef>
#include <string>
#include <vector>

// Text in lines of limited width.

namespace raylab {

/// The number of characters that a text shows: code points, not bytes.
std::size_t length_shown(const std::string& text);

/// The words of a text in lines of at most `width` characters. A word that is longer has a line of its own. There is at
/// least one line.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace raylab
