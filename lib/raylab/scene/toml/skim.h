#pragma once

#include <string>
#include <string_view>

namespace raylab::toml_file {

/// Throws an Error for what no scene has outside strings and comments: characters beyond ASCII, because toml++'s
/// messages about an invisible one do not help to find it, and dotted keys of more than 32 names, because two
/// characters of the file make a table of 300 bytes (and over 10^5 of them overflow the stack of toml++ 3.3). A scene's
/// own tables are nested 6 deep.
void check_outside_strings(std::string_view text, const std::string& file);

/// The most bytes that the text takes while it is parsed, estimated from what stands outside strings and comments. It
/// throws the same Errors.
double parsed_bytes(std::string_view text, const std::string& file);

}  // namespace raylab::toml_file
