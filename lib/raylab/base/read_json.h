#pragma once

#include "raylab/base/memory_limit.h"

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

/// The most names that an object is read with. They are kept in the order of the text and searched one by one, so twice
/// as many take four times as long; the lab's own objects have some 20.
inline constexpr std::size_t most_names = 256;

/// The value that JSON text holds, keys in the order of the text. Error, with `source` and the place in it, for what is
/// no JSON, for deeper nesting or more names and, before it is taken, for more memory than the limit: what takes two
/// bytes in the text may take a hundred.
nlohmann::ordered_json json_from_text(std::string_view text, const std::string& source, const MemoryLimit& limit = {});

/// The same of a file of at most 256 MiB: half a million nodes of a ray tree.
nlohmann::ordered_json read_json(const std::filesystem::path& path, const MemoryLimit& limit = {});

}  // namespace raylab
