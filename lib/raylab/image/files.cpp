#include "raylab/image/files.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/image/color.h"
#include "raylab/image/finite.h"
#include "raylab/image/openimageio.h"
#include "raylab/image/picture_name.h"
#include "raylab/image/png_chunks.h"
#include "raylab/image/srgb_bytes.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace raylab {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

// By the first bytes, never by the name: OpenImageIO would otherwise try all its forty formats in turn.
std::string format_of(const fs::path& path) {
    std::error_code problem;
    if (!fs::exists(path, problem)) throw Error({path.string()}, "a picture", "nothing there");
    if (!fs::is_regular_file(path, problem))
        throw Error({path.string()}, "a picture", "something that is no regular file");
    std::array<char, 8> bytes{};
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), bytes.size());
    const std::string head(bytes.data(), static_cast<std::size_t>(file.gcount()));
    if (head == "\x89PNG\r\n\x1a\n") return "png";
    if (head.starts_with("\x76\x2f\x31\x01")) return "openexr";
    throw Error({path.string()}, "an EXR or PNG picture", "another kind of file");
}

// Where red, green and blue stand among the channels; a grey picture has one channel for all three.
std::array<std::size_t, 3> color_channels(const openimageio::Picture& picture, const fs::path& path) {
    const auto& names = picture.channels;
    const auto place = [&](const char* name) {
        return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    const std::array named{place("R"), place("G"), place("B")};
    if (std::ranges::max(named) < names.size()) return named;
    if (names.size() == 1 || place("Y") == 0) return {0, 0, 0};
    throw Error({path.string()}, "channels R, G and B, or one", std::to_string(names.size()) + " others");
}

// Before memory is taken: neither format packs more than 2^14 pixels into a byte (deflate: at most 1032 bytes to one).
void refuse_size(const openimageio::Picture& picture, const fs::path& path) {
    const auto bytes = static_cast<std::int64_t>(fs::file_size(path));
    const std::int64_t most = std::min(most_pixels, bytes << 14);
    const auto [width, height, depth] = std::array{picture.width, picture.height, picture.depth};
    if (width >= 1 && height >= 1 && depth <= 1 && width <= most / height) return;
    throw Error({path.string()}, "1 to " + std::to_string(most) + " pixels in " + std::to_string(bytes) + " bytes",
                std::to_string(width) + " x " + std::to_string(height));
}

Image image_of(const openimageio::Picture& picture, const std::array<std::size_t, 3>& channels,
               const std::string& format) {
    const auto linear = [&](float v) { return format == "png" ? static_cast<float>(linear_from_srgb(v)) : v; };
    Image image(picture.width, picture.height);
    const float* pixel = picture.values.data();
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x, pixel += picture.channels.size())
            image.at(x, y) = {linear(pixel[channels[0]]), linear(pixel[channels[1]]), linear(pixel[channels[2]])};
    return image;
}

/// libpng's own colours are 8 bit and sRGB where nothing else is said.
void write_png(const fs::path& path, const Image& image) {
    const auto bytes = srgb_bytes(image);
    png_image header{.version = PNG_IMAGE_VERSION,
                     .width = static_cast<png_uint_32>(image.width()),
                     .height = static_cast<png_uint_32>(image.height()),
                     .format = PNG_FORMAT_RGB};
    if (png_image_write_to_file(&header, path.c_str(), 0, bytes.data(), 0, nullptr) == 0)
        throw Error({path.string()}, "a place that can be written", header.message);
}

void write_exr(const fs::path& path, const Image& image) {
    try {
        openimageio::functions().write_exr(path.string(), image.width(), image.height(), &image.pixels().data()->r);
    } catch (const openimageio::Failure& failure) {
        throw Error({path.string()}, "a place that can be written", failure.reason);
    }
}

void refuse_non_finite(const Image& image, const fs::path& path) {
    const auto found = first_non_finite(image);
    if (!found) return;
    const auto& [x, y, value] = *found;
    throw Error({path.string(), 0, "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")"}, "finite values",
                std::to_string(value.r) + " " + std::to_string(value.g) + " " + std::to_string(value.b) +
                    "; nothing is written");
}

}  // namespace

Image read_image(const fs::path& path) {
    const std::string format = format_of(path);
    if (format == "png")
        if (const auto damage = png_damage(read_file(path)); !damage.empty())
            throw Error({path.string()}, "a whole PNG picture", damage);
    std::array<std::size_t, 3> channels{};
    const auto accept = [&](const openimageio::Picture& picture) {
        refuse_size(picture, path);
        channels = color_channels(picture, path);
    };
    try {
        const auto picture = openimageio::functions().read(path.string(), format, accept);
        return image_of(picture, channels, format);
    } catch (const openimageio::Failure& failure) {
        throw Error({path.string()}, "a whole picture that can be read", failure.reason);
    }
}

void check_picture_name(const fs::path& path) {
    const std::string extension = path.extension().string();
    if (extension != ".exr" && extension != ".png")
        throw Error({path.string()}, "a name ending in .exr or .png", "'" + extension + "'");
}

void write_image(const Image& image, const fs::path& path) {
    check_picture_name(path);
    if (image.pixels().empty()) throw Error({path.string()}, "a picture of at least one pixel", "an empty one");
    refuse_non_finite(image, path);
    const auto write = path.extension() == ".png" ? write_png : write_exr;
    write_file_with(path, [&](const fs::path& beside) { write(beside, image); });
}

std::string write_picture(const Image& image, const fs::path& folder, const std::string& name) {
    write_image(image, folder / (name + ".exr"));
    write_image(image, folder / (name + ".png"));
    return name + ".png";
}

}  // namespace raylab
