#include "raylab/base/printable.h"

#include <cstdint>
#include <cstdio>
#include <iterator>
#include <sstream>

namespace raylab {

namespace {

/// A character of a text, or a byte that belongs to none.
struct Character {
    std::uint32_t code;  // its Unicode number or, where the text is not UTF-8, the byte
    std::size_t bytes;
    bool valid;
};

constexpr bool continues(unsigned char byte) { return (byte & 0xc0) == 0x80; }

/// The first character of a text that is not empty (Unicode 15, table 3-7: overlong forms and surrogates are invalid).
Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    const unsigned char lead = byte(0);
    const Character broken{lead, 1, false};
    if (lead < 0x80) return {lead, 1, true};
    const std::size_t length = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
    if (length == 0 || text.size() < length) return broken;
    std::uint32_t code = lead & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (!continues(byte(i))) return broken;
        code = code << 6 | (byte(i) & 0x3fu);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    return overlong || surrogate || code > 0x10ffff ? broken : Character{code, length, true};
}

constexpr bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

// Whether it is Unicode's line or paragraph separator, or in Bidi_Control (UAX 9).
constexpr bool breaks_or_turns(std::uint32_t code) {
    return (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0x200e ||
           code == 0x200f || code == 0x061c;
}

std::string escaped(const Character& character) {
    char text[16];
    std::snprintf(text, sizeof text, character.valid ? "\\u{%x}" : "\\x%02x", static_cast<unsigned>(character.code));
    return text;
}

std::string printable_but(std::string_view text, std::string_view kept) {
    std::string shown;
    while (!text.empty()) {
        const Character character = first_character(text);
        const bool stays = kept.find(text[0]) != std::string_view::npos;
        const bool hidden = !character.valid || is_control(character.code) || breaks_or_turns(character.code);
        shown += hidden && !stays ? escaped(character) : std::string(text.substr(0, character.bytes));
        text.remove_prefix(character.bytes);
    }
    return shown;
}

}  // namespace

std::string printable(std::string_view text) { return printable_but(text, ""); }

std::string printable_lines(std::string_view text) { return printable_but(text, "\n\t"); }

std::string on_one_line(std::string_view text) {
    std::istringstream stream{std::string(text)};
    std::string line;
    for (auto word = std::istream_iterator<std::string>(stream); word != std::istream_iterator<std::string>(); ++word)
        line += (line.empty() ? "" : " ") + *word;
    return line;
}

}  // namespace raylab
