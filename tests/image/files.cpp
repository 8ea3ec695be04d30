#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/image/color.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_name.h"
#include "raylab/image/png_chunks.h"

#include <png.h>

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <thread>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

// A folder for each test case, which is removed at its end.
class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / ("raylab_image_test_" + std::to_string(count_++))) {
        fs::remove_all(path_);
        fs::create_directories(path_);
    }
    ~Folder() { fs::remove_all(path_); }
    fs::path operator/(const std::string& name) const { return path_ / name; }
    bool empty() const { return fs::is_empty(path_); }

private:
    static inline int count_ = 0;
    fs::path path_;
};

Image odd_values() {
    Image image(5, 3);
    image.at(0, 0) = {-1.5f, 1e30f, 1e-30f};
    image.at(4, 2) = {std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(), 0.1f};
    image.at(2, 1) = {-0.0f, 1.0f / 3, 65520};
    return image;
}

}  // namespace

TEST_CASE("EXR keeps every bit of every float") {
    const Folder folder;
    write_image(odd_values(), folder / "a.exr");
    const Image back = read_image(folder / "a.exr");
    REQUIRE(back.width() == 5);
    REQUIRE(back.height() == 3);
    CHECK(back.pixels() == odd_values().pixels());
    CHECK(std::signbit(back.at(2, 1).r));
}

TEST_CASE("a picture's file is the same bytes whenever it is written") {
    const Folder folder;
    for (const char* name : {"a.exr", "a.png"}) write_image(odd_values(), folder / name);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // a date would contain seconds
    for (const char* name : {"b.exr", "b.png"}) write_image(odd_values(), folder / name);
    CHECK(read_file(folder / "a.exr") == read_file(folder / "b.exr"));
    CHECK(read_file(folder / "a.png") == read_file(folder / "b.png"));
}

TEST_CASE("PNG keeps all 256 code values, and clamps the rest") {
    const Folder folder;
    Image image(256, 2);
    for (int x = 0; x < 256; ++x) image.at(x, 0) = pixel_from_srgb(x, 255 - x, x);
    image.at(0, 1) = {-3, 0.5f, 9};
    write_image(image, folder / "a.png");
    const Image back = read_image(folder / "a.png");
    for (int x = 0; x < 256; ++x) {
        CHECK(srgb_byte(back.at(x, 0).r) == x);
        CHECK(srgb_byte(back.at(x, 0).g) == 255 - x);
    }
    CHECK(back.at(0, 1).r == 0);
    CHECK(back.at(0, 1).b == 1);
    CHECK(srgb_byte(back.at(0, 1).g) == 188);
}

TEST_CASE("a picture with a value that is not finite is not written, and the pixel is named") {
    const Folder folder;
    for (const char* name : {"a.exr", "a.png"})
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
            Image image(4, 4);
            image.at(3, 2).g = bad;
            CHECK_THROWS_WITH(write_image(image, folder / name), Catch::Contains("pixel (3, 2)"));
        }
    CHECK(folder.empty());
}

TEST_CASE("other extensions and empty pictures are refused, nothing is written") {
    const Folder folder;
    CHECK_THROWS_AS(write_image(Image(2, 2), folder / "a.jpg"), Error);
    CHECK_THROWS_AS(write_image(Image(2, 2), folder / "a"), Error);
    CHECK_THROWS_AS(check_picture_name("a.jpg"), Error);
    CHECK_NOTHROW(check_picture_name("a.exr"));
    CHECK_THROWS_AS(write_image(Image(), folder / "a.png"), Error);
    CHECK_THROWS_AS(write_image(Image(2, 2), "/proc/no/such/place/a.png"), Error);
    CHECK(folder.empty());
}

TEST_CASE("what cannot be read is an error that names the file") {
    const Folder folder;
    CHECK_THROWS_WITH(read_image(folder / "absent.png"), Catch::Contains("absent.png"));
    write_file(folder / "text.png", "P3 1 1 255 0 0 0");
    CHECK_THROWS_WITH(read_image(folder / "text.png"), Catch::Contains("expected an EXR or PNG picture"));
    write_file(folder / "empty.exr", "");
    CHECK_THROWS_AS(read_image(folder / "empty.exr"), Error);
    CHECK_THROWS_AS(read_image(folder / "."), Error);
}

TEST_CASE("a grey picture has its value in all three channels, whether it says how opaque it is or not") {
    const Folder folder;
    const std::array<png_byte, 4> grey{0, 100, 200, 255}, grey_and_opacity{0, 255, 200, 128};
    const auto write = [&](const char* name, png_uint_32 width, png_uint_32 format, const void* bytes) {
        png_image header{.version = PNG_IMAGE_VERSION, .width = width, .height = 1, .format = format};
        REQUIRE(png_image_write_to_file(&header, (folder / name).c_str(), 0, bytes, 0, nullptr) != 0);
        return read_image(folder / name);
    };
    const Image plain = write("grey.png", 4, PNG_FORMAT_GRAY, grey.data());
    CHECK(srgb_byte(plain.at(1, 0).r) == 100);
    CHECK((plain.at(2, 0).r == plain.at(2, 0).g && plain.at(2, 0).g == plain.at(2, 0).b));
    const Image opaque = write("grey_and_opacity.png", 2, PNG_FORMAT_GA, grey_and_opacity.data());
    REQUIRE(opaque.width() == 2);
    CHECK(opaque.at(0, 0) == Pixel{0, 0, 0});
    CHECK((opaque.at(1, 0).r == opaque.at(1, 0).g && opaque.at(1, 0).g == opaque.at(1, 0).b));
}

TEST_CASE("a truncated picture is an error wherever it is cut") {
    const Folder folder;
    Image image(64, 64);
    for (int i = 0; i < 64 * 64; ++i)
        image.at(i % 64, i / 64) = {std::sin(0.1f * static_cast<float>(i * i % 997)), 0.5f, 0};
    for (const std::string extension : {".exr", ".png"}) {
        write_image(image, folder / ("whole" + extension));
        const std::string bytes = read_file(folder / ("whole" + extension));
        for (int tenth = 0; tenth < 10; ++tenth) {
            const auto name = folder / ("cut" + extension);
            write_file(name, bytes.substr(0, bytes.size() * static_cast<std::size_t>(tenth) / 10));
            INFO(extension << " cut to " << tenth << " tenths");
            CHECK_THROWS_AS(read_image(name), Error);
        }
    }
}

TEST_CASE("one flipped bit anywhere in a PNG is noticed") {
    const Folder folder;
    write_image(Image(16, 16, {0.2f, 0.4f, 0.6f}), folder / "whole.png");
    const std::string bytes = read_file(folder / "whole.png");
    CHECK(png_damage(bytes).empty());
    for (std::size_t i = 8; i < bytes.size(); ++i) {
        std::string damaged = bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ 4);
        INFO("byte " << i);
        CHECK_FALSE(png_damage(damaged).empty());
    }
}

TEST_CASE("a header that promises more pixels than its file can hold is refused before memory is taken") {
    const Folder folder;
    write_image(Image(4, 4), folder / "small.png");
    std::string bytes = read_file(folder / "small.png");
    bytes[16] = 0, bytes[17] = 0, bytes[18] = 0x3f, bytes[19] = 0;  // width 16128 ...
    bytes[20] = 0, bytes[21] = 0, bytes[22] = 0x3f, bytes[23] = 0;  // ... and height, in the IHDR chunk
    const std::string checksum = "\x51\x50\x81\x24";  // of that header: 8 bits RGB, deflate, not interlaced
    bytes.replace(29, 4, checksum);
    REQUIRE(png_damage(bytes).empty());
    write_file(folder / "liar.png", bytes);
    CHECK_THROWS_AS(read_image(folder / "liar.png"), Error);
}

TEST_CASE("what a file says decides, not its name") {
    const Folder folder;
    write_image(odd_values(), folder / "a.exr");
    fs::rename(folder / "a.exr", folder / "a.png");
    CHECK(read_image(folder / "a.png").pixels() == odd_values().pixels());
}

TEST_CASE("who reads or writes no picture does not wait for OpenImageIO's libraries") {
    // Composed here, so that this file is not found itself.
    const std::string library = std::string("libOpenImage") + "IO.so";
    CHECK(read_file("/proc/self/exe").find(library) == std::string::npos);
    CHECK(read_file(RAYLAB_BUILD "/raylab_openimageio.so").find(library) != std::string::npos);
}
