#pragma once

#include <string>
#include <string_view>

namespace raylab::toml_file {

/// Error for text that toml++ 3.3 does not survive: it recurses over the tables that a dotted key makes (some 10^5 dots
/// overflow the stack), and characters beyond ASCII lead it to a point that it declares unreachable (its issue 190):
/// outside quotes and comments, where they are no TOML, and after a backslash that ends its line, where they are.
/// Refuses quotes inside a word, too: no TOML, and toml++ takes what follows for no string.
void refuse_what_breaks_the_parser(std::string_view text, const std::string& file);

}  // namespace raylab::toml_file
