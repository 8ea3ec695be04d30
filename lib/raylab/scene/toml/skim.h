#pragma once

#include <string>
#include <string_view>

namespace raylab::toml_file {

/// Error for what no scene has outside strings and comments: characters beyond ASCII, which toml++ calls by no name that
/// helps who looks for a blank that is none, and dotted keys of more than 1000 names (over the tables that 10^5 make, toml++
/// 3.3 overflows the stack).
void check_outside_strings(std::string_view text, const std::string& file);

}  // namespace raylab::toml_file
