#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

// The one place where JSON is parsed. nlohmann's parser takes any depth, but what then walks the value (its destructor
// in part, dump, comparisons) recurses once a level, and 100 000 levels end the program by a stack overflow.

namespace raylab {

/// The deepest nesting of arrays and objects that is read; the lab's own files have 6.
inline constexpr std::size_t deepest_json = 64;

/// The value that JSON text holds, keys in the order of the text. Error, with `source` and the place in it, for what is
/// no JSON and for deeper nesting.
nlohmann::ordered_json json_from_text(std::string_view text, const std::string& source);

/// The same of a file of at most `limit` bytes.
nlohmann::ordered_json read_json(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 28);

}  // namespace raylab
