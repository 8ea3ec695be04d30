#include "raylab/image/check_picture_size.h"

#include "raylab/image/image.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

constexpr std::uint64_t max_pixels = std::uint64_t{1} << 28;

}  // namespace

void check_picture_size(const PictureClaim& claim, const std::string& file, const MemoryLimit& limit) {
    // Neither format packs more than 2^14 pixels into a byte (deflate: at most 1032 bytes to one).
    const auto largest = static_cast<double>(std::min(max_pixels, claim.file_bytes << 14));
    const auto width = static_cast<double>(claim.width), height = static_cast<double>(claim.height);
    if (claim.width < 1 || claim.height < 1 || width * height > largest)
        throw Error({file}, fmt::format("1 to {} pixels in {} bytes", largest, claim.file_bytes),
                    fmt::format("{} x {}", claim.width, claim.height));
    check_memory({.bytes = width * height * sizeof(Pixel) + claim.buffers,
                  .what = "a picture",
                  .why = fmt::format("{} x {} x {}", claim.what, claim.width, claim.height)},
                 limit, {file});
}

}  // namespace raylab
