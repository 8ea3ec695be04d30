#include "raylab/base/bytes.h"

#include "fuzz/any_picture.h"

#include <algorithm>

namespace {

// Whether a header's data window or tile (OpenEXR File Layout, "Attribute types") has more pixels than are fuzzed.
bool is_large(std::string_view bytes) {
    const auto claims = [&](std::string_view attribute, auto size_at) {
        for (auto at = bytes.find(attribute); at != bytes.npos; at = bytes.find(attribute, at + 1)) {
            const std::size_t value = at + attribute.size() + 4;  // the attribute's length is in between
            if (value + 16 > bytes.size()) return false;
            const auto [width, height] = size_at(value);
            if (std::max(width, height) > fuzzed_pixels) return true;
            if (std::min(width, height) > 0 && width * height > fuzzed_pixels) return true;
        }
        return false;
    };
    const auto whole = [&](std::size_t at) {
        return std::int64_t{raylab::number_at<std::int32_t>(bytes, at, std::endian::little)};
    };
    using namespace std::string_view_literals;
    return claims(
               "dataWindow\0box2i\0"sv,
               [&](auto at) { return std::pair(whole(at + 8) - whole(at) + 1, whole(at + 12) - whole(at + 4) + 1); }) ||
           claims("tiles\0tiledesc\0"sv, [&](auto at) { return std::pair(whole(at), whole(at + 4)); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (is_large({reinterpret_cast<const char*>(data), size})) return -1;
    return read_any_picture(data, size);
}
