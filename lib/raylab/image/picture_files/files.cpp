#include "raylab/image/picture_files/files.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/thread_pool.h"
#include "raylab/base/with_all_replaced.h"
#include "raylab/image/check_picture_size.h"
#include "raylab/image/exr_header.h"
#include "raylab/image/finite.h"
#include "raylab/image/picture_files/openimageio.h"
#include "raylab/image/picture_files/read_png.h"
#include "raylab/image/picture_name.h"
#include "raylab/image/srgb_bytes.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <fstream>
#include <string>
#include <vector>

namespace raylab {

namespace {

namespace fs = std::filesystem;

enum class Format { exr, png };

// The format is determined by the first bytes, never by the name.
Format format_of(const fs::path& path) {
    std::error_code problem;
    if (!fs::exists(path, problem)) throw Error({path.string()}, "a picture", "nothing there");
    if (!fs::is_regular_file(path, problem))
        throw Error({path.string()}, "a picture", "something that is no regular file");
    std::array<char, 8> bytes{};
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), bytes.size());
    const std::string head(bytes.data(), static_cast<std::size_t>(file.gcount()));
    if (head == "\x89PNG\r\n\x1a\n") return Format::png;
    if (head.starts_with("\x76\x2f\x31\x01")) return Format::exr;
    throw Error({path.string()}, "an EXR or PNG picture", "another kind of file");
}

// The places of red, green and blue among the channels; a grey picture has one channel for all three.
std::array<int, 3> color_channels(const openimageio::Picture& picture, const fs::path& path) {
    const auto& names = picture.channels;
    const auto place = [&](const char* name) {
        return static_cast<int>(std::ranges::find(names, name) - names.begin());
    };
    const std::array named{place("R"), place("G"), place("B")};
    if (std::ranges::max(named) < std::ssize(names)) return named;
    if (names.size() == 1 || place("Y") == 0) return {0, 0, 0};
    throw Error({path.string()}, "channels R, G and B, or one", std::to_string(names.size()) + " others");
}

// The memory that OpenEXR and OpenImageIO take in addition to the pixels. Chunks are decompressed with all their
// channels, whatever is read: two for each thread, and the bytes that they were compressed to. Lines are converted 256
// at a time.
double exr_buffers(const ExrHeader& header) {
    const auto product = [](auto... factors) { return (1.0 * ... * static_cast<double>(factors)); };
    const double chunk = header.tile_width > 0 ? product(header.tile_width, header.tile_height)
                                               : product(header.width, std::min(header.height, header.chunk_lines));
    const double converted = product(header.width, std::min<std::int64_t>(header.height, 256), sizeof(Pixel));
    return 2 * 2 * product(core_count(), chunk, header.pixel_bytes) + converted;
}

Image read_exr(const fs::path& path, const MemoryLimit& limit) {
    const ExrHeader header = read_exr_header(path);
    check_picture_size({.width = header.width,
                        .height = header.height,
                        .file_bytes = fs::file_size(path),
                        .buffers = exr_buffers(header),
                        .what = fmt::format("{} channels", header.channels)},
                       path.string(), limit);
    Image image;
    const auto choose = [&](const openimageio::Picture& picture) -> openimageio::Wanted {
        if (picture.width != header.width || picture.height != header.height || picture.depth > 1)
            throw Error({path.string()}, fmt::format("{} x {} pixels as the header says", header.width, header.height),
                        fmt::format("{} x {} x {}", picture.width, picture.height, picture.depth));
        const auto [r, g, b] = color_channels(picture, path);
        image = Image(picture.width, picture.height);
        return {{r, g, b}, &image.at(0, 0).r};
    };
    try {
        openimageio::functions().read_exr(path.string(), choose);
    } catch (const openimageio::Failure& failure) {
        throw Error({path.string()}, "a whole picture that can be read", failure.reason);
    }
    return image;
}

/// The path to which a picture is written for now, and the name to use in messages.
struct Written {
    fs::path file, name;
};

Error refused(const Written& to, const std::string& reason) {
    return {{to.name.string()}, "a place that can be written", with_all_replaced(reason, to.file.string(), "it")};
}

void write_exr(const Written& to, const Image& image) {
    try {
        openimageio::functions().write_exr(to.file.string(), {image.width(), image.height(), 1, {"R", "G", "B"}},
                                           &image.pixels().data()->r);
    } catch (const openimageio::Failure& failure) {
        throw refused(to, failure.reason);
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

std::string png_bytes(const Image& image) { return png_bytes(image.width(), image.height(), srgb_bytes(image)); }

// libpng's defaults for colours are 8 bits and sRGB.
std::string png_bytes(int width, int height, std::span<const std::uint8_t> colors) {
    assert(colors.size() == 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    png_image header{.version = PNG_IMAGE_VERSION,
                     .width = static_cast<png_uint_32>(width),
                     .height = static_cast<png_uint_32>(height),
                     .format = PNG_FORMAT_RGB};
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    std::string file(size, '\0');
    if (png_image_write_to_memory(&header, file.data(), &size, 0, colors.data(), 0, nullptr) == 0)
        throw Error(std::string("no picture: ") + header.message);
    file.resize(size);
    return file;
}

Image read_image(const fs::path& path, const MemoryLimit& limit) {
    if (format_of(path) == Format::exr) return read_exr(path, limit);
    return read_png(read_file(path), path.string(), limit);
}

void check_picture_name(const fs::path& path) {
    const std::string extension = path.extension().string();
    if (extension != ".exr" && extension != ".png")
        throw Error({path.string()}, "a name ending in .exr or .png", "'" + extension + "'");
}

void write_image(const Image& image, const OutputFile& file) {
    const fs::path& path = file.path;
    check_picture_name(path);
    if (image.pixels().empty()) throw Error({path.string()}, "a picture of at least one pixel", "an empty one");
    refuse_non_finite(image, path);
    if (path.extension() == ".png") return write_file(file, png_bytes(image));
    write_file_with(file, [&](const fs::path& temporary) { write_exr({temporary, path}, image); });
}

}  // namespace raylab
