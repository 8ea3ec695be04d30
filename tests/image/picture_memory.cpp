#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/image/color.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_files/read_png.h"

#include "image/picture_bytes.h"

#include <unistd.h>
#include <chrono>
#include <filesystem>

using namespace raylab;
using Catch::Contains;

namespace {

constexpr MemoryLimit a_mebibyte{1 << 20}, a_gibibyte{1 << 30};

Image read_exr_bytes(const std::string& bytes, const MemoryLimit& limit) {
    const auto file = std::filesystem::temp_directory_path() / ("raylab_" + std::to_string(getpid()) + ".exr");
    write_file(file, bytes);
    try {
        const Image image = read_image(file, limit);
        std::filesystem::remove(file);
        return image;
    } catch (...) {
        std::filesystem::remove(file);
        throw;
    }
}

std::vector<std::string> channels(std::size_t count) {
    std::vector<std::string> names{"B", "G", "R"};
    while (names.size() < count) names.push_back("x" + std::to_string(1000 + names.size()));
    return names;
}

// The pixel of a PNG with only one, whose bytes these are.
Pixel only_pixel(PngBytes png, const std::string& bytes) {
    png.lines = std::string(1, '\0') + bytes;
    return read_png(png.file(), "a.png", a_mebibyte).at(0, 0);
}

}  // namespace

TEST_CASE("a PNG that needs more memory than the limit is refused, with what it needs") {
    const std::string file = PngBytes{8192, 8192, 1, 0, std::string(8192 * 1025, '\0')}.file();
    REQUIRE(file.size() < 20'000);
    CHECK_THROWS_WITH(read_png(file, "a.png", a_mebibyte),
                      "a.png: expected at most 1.0 MiB (--memory), found a picture that needs 960.0 MiB: "
                      "3 values of 8 bits x 8192 x 8192");
}

TEST_CASE("an EXR that needs more memory than the limit is refused, with what it needs") {
    const ExrClaim claim{16384, 16384, channels(256), 3, {}, 32'768};
    CHECK_THROWS_WITH(read_exr_bytes(claim.file(), a_gibibyte),
                      Contains(".exr: expected at most 1.0 GiB (--memory), found a picture that needs ") &&
                          Contains(" GiB: 256 channels x 16384 x 16384"));
    CHECK_THROWS_WITH(read_exr_bytes(ExrClaim{512, 512, channels(3), 3, {}, 1000}.file(), a_mebibyte),
                      Contains(" MiB: 3 channels x 512 x 512"));
}

TEST_CASE("tiles larger than their picture count as what they claim") {
    const std::string tiles = ExrClaim::integers({32768, 32768}) + '\0';
    const ExrClaim claim{64, 64, channels(3), 3, ExrClaim::attribute("tiles", "tiledesc", tiles), 100};
    CHECK_THROWS_WITH(read_exr_bytes(claim.file(), a_gibibyte), Contains("a picture that needs "));
}

TEST_CASE("100 000 attributes or 2000 channels of an EXR are refused at once") {
    std::string attributes;
    for (int i = 0; i < 100'000; ++i)
        attributes += ExrClaim::attribute("a" + std::to_string(i), "int", std::string(4, '\0'));
    const auto begun = std::chrono::steady_clock::now();
    CHECK_THROWS_WITH(read_exr_bytes(ExrClaim{8, 8, channels(3), 3, attributes, 100}.file(), a_gibibyte),
                      Contains("expected at most 4096 attributes"));
    CHECK_THROWS_WITH(read_exr_bytes(ExrClaim{8, 8, channels(2000), 3, {}, 100}.file(), a_gibibyte),
                      Contains("expected at most 1024 channels"));
    // Read one by one, they would take 40 s and more.
    CHECK(std::chrono::steady_clock::now() - begun < std::chrono::seconds(5));
}

TEST_CASE("a PNG of any kind gives the colours of its code values") {
    CHECK(only_pixel({1, 1}, {7, 100, '\xff'}) == pixel_from_srgb(7, 100, 255));
    CHECK(only_pixel({1, 1, 8, 6}, {7, 100, '\xff', 0}) == pixel_from_srgb(7, 100, 255));  // alpha is ignored
    CHECK(only_pixel({1, 1, 8, 0}, {100}) == pixel_from_srgb(100, 100, 100));
    CHECK(only_pixel({1, 1, 8, 4}, {100, 3}) == pixel_from_srgb(100, 100, 100));
    CHECK(only_pixel({1, 1, 1, 0}, {'\x80'}) == pixel_from_srgb(255, 255, 255));
    CHECK(only_pixel({1, 1, 4, 0}, {'\x30'}) == pixel_from_srgb(51, 51, 51));
    CHECK(only_pixel({1, 1, 2, 3, {}, {0, 0, 0, 1, 2, 3}}, {'\x40'}) == pixel_from_srgb(1, 2, 3));
    const Pixel wide = only_pixel({1, 1, 16, 2}, {'\x12', '\x34', '\x80', 0, '\xff', '\xff'});
    CHECK(wide.r == static_cast<float>(linear_from_srgb(0x1234 / 65535.0)));
    CHECK(wide.b == 1);
}
