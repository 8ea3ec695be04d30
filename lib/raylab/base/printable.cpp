#include "raylab/base/printable.h"

#include "raylab/base/utf8.h"

#include <cstdint>
#include <cstdio>
#include <iterator>
#include <sstream>

namespace raylab {

namespace {

constexpr bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

// Whether it is Unicode's line or paragraph separator, or in Bidi_Control (UAX 9).
constexpr bool breaks_or_turns(std::uint32_t code) {
    return (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0x200e ||
           code == 0x200f || code == 0x061c;
}

std::string escaped(const Utf8Character& character) {
    char text[16];
    std::snprintf(text, sizeof text, character.valid ? "\\u{%x}" : "\\x%02x", static_cast<unsigned>(character.code));
    return text;
}

std::string printable_but(std::string_view text, std::string_view kept) {
    std::string shown;
    while (!text.empty()) {
        const Utf8Character character = first_character(text);
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
