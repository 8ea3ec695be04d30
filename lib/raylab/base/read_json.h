#pragma once

#include "raylab/base/memory_limit.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

// The only place where JSON is parsed. nlohmann's parser takes any depth, but functions that visit the value (its
// destructor in part, dump, comparisons) recurse once for each level, and 100 000 levels end the program by a stack
// overflow.

namespace raylab {

/// The deepest nesting of arrays and objects that is accepted; the lab's own files have 6.
inline constexpr std::size_t deepest_json = 64;

/// The most names that an object may have. They are kept in the order of the text and searched one by one, so the time
/// grows with the square of their number; the lab's own objects have some 20.
inline constexpr std::size_t max_names = 256;

/// Parses JSON text; keys keep the order of the text. It throws an Error, with `source` and the place in it, for
/// invalid JSON, for deeper nesting or more names, and, before allocating, for more memory than the limit: two bytes of
/// the text may take a hundred bytes of memory.
nlohmann::ordered_json json_from_text(std::string_view text, const std::string& source, const MemoryLimit& limit = {});

/// Parses a file of at most 256 MiB, which is half a million nodes of a ray tree.
nlohmann::ordered_json read_json(const std::filesystem::path& path, const MemoryLimit& limit = {});

}  // namespace raylab
