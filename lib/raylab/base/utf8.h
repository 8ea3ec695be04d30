#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace raylab {

/// A character of a text, or a byte that belongs to none.
struct Utf8Character {
    std::uint32_t code;  // its Unicode number or, where the text is not UTF-8, the byte
    std::size_t bytes;
    bool valid;
};

/// The first character of a text that is not empty (Unicode 15, table 3-7: overlong forms and surrogates are invalid).
Utf8Character first_character(std::string_view text);

}  // namespace raylab
