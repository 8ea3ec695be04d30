#pragma once

#include <string>
#include <string_view>

namespace raylab::toml_file {

/// Error for two kinds of text that is no TOML and that toml++ 3.3 does not survive: it recurses over the tables that a
/// dotted key makes (some 10^5 dots overflow the stack), and characters beyond ASCII, outside quotes and comments, lead
/// it to a point that it declares unreachable.
void refuse_what_breaks_the_parser(std::string_view text, const std::string& file);

}  // namespace raylab::toml_file
