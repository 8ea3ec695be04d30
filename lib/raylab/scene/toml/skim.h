#pragma once

#include <string>
#include <string_view>

namespace raylab::toml_file {

/// Error for two kinds of text that is no TOML: dotted keys of so many names that toml++ 3.3 overflows the stack over the
/// tables they make (some 10^5 dots), and characters beyond ASCII outside quotes and comments, which toml++ calls by no
/// name that helps who looks for a blank that is none.
void refuse_what_breaks_the_parser(std::string_view text, const std::string& file);

}  // namespace raylab::toml_file
