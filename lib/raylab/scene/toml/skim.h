#pragma once

#include <string>
#include <string_view>

namespace raylab::toml_file {

/// Error for what no scene has outside strings and comments: characters beyond ASCII, which toml++ calls by no name
/// that helps who looks for a blank that is none, and dotted keys of more than 32 names: each makes a table, of 300
/// bytes for two in the file (and over 10^5 of them toml++ 3.3 overflows the stack). A scene's own tables nest 6 deep.
void check_outside_strings(std::string_view text, const std::string& file);

/// How many bytes the text takes at most while it is parsed, by what stands outside strings and comments; Errors as
/// above.
double parsed_bytes(std::string_view text, const std::string& file);

}  // namespace raylab::toml_file
