#include "raylab/base/utf8.h"

namespace raylab {

namespace {

bool continues(unsigned char byte) { return (byte & 0xc0) == 0x80; }

}  // namespace

Utf8Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    const unsigned char lead = byte(0);
    const Utf8Character broken{lead, 1, false};
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
    return overlong || surrogate || code > 0x10ffff ? broken : Utf8Character{code, length, true};
}

}  // namespace raylab
