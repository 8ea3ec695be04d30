#include "raylab/image/files.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/image/color.h"
#include "raylab/image/finite.h"
#include "raylab/image/png_chunks.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
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
std::array<int, 3> color_channels(const OIIO::ImageSpec& spec, const fs::path& path) {
    const std::array<int, 3> named{spec.channelindex("R"), spec.channelindex("G"), spec.channelindex("B")};
    if (named[0] >= 0 && named[1] >= 0 && named[2] >= 0) return named;
    if (spec.nchannels == 1 || spec.channelindex("Y") == 0) return {0, 0, 0};
    throw Error({path.string()}, "channels R, G and B, or one", std::to_string(spec.nchannels) + " others");
}

// Before memory is taken: neither format packs more than 2^14 pixels into a byte (deflate: at most 1032 bytes to one).
void refuse_size(const OIIO::ImageSpec& spec, const fs::path& path) {
    const auto bytes = static_cast<std::int64_t>(fs::file_size(path));
    const std::int64_t most = std::min(most_pixels, bytes << 14);
    if (spec.width >= 1 && spec.height >= 1 && spec.depth <= 1 && spec.width <= most / spec.height) return;
    throw Error({path.string()}, "1 to " + std::to_string(most) + " pixels in " + std::to_string(bytes) + " bytes",
                std::to_string(spec.width) + " x " + std::to_string(spec.height));
}

Image image_of(const std::vector<float>& values, const OIIO::ImageSpec& spec, const std::array<int, 3>& channels,
               const std::string& format) {
    const auto linear = [&](float v) { return format == "png" ? static_cast<float>(linear_from_srgb(v)) : v; };
    Image image(spec.width, spec.height);
    const float* pixel = values.data();
    for (int y = 0; y < spec.height; ++y)
        for (int x = 0; x < spec.width; ++x, pixel += spec.nchannels)
            image.at(x, y) = {linear(pixel[channels[0]]), linear(pixel[channels[1]]), linear(pixel[channels[2]])};
    return image;
}

std::string reason(const std::string& from_openimageio) {
    return from_openimageio.empty() ? "a damaged one" : from_openimageio;
}

std::vector<std::uint8_t> srgb_bytes(const Image& image) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * image.pixels().size());
    for (const Pixel& pixel : image.pixels())
        for (const float light : {pixel.r, pixel.g, pixel.b}) bytes.push_back(srgb_byte(light));
    return bytes;
}

void write_pixels(const fs::path& path, const Image& image, const std::string& format) {
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) throw Error({path.string()}, "OpenImageIO to write " + format, "that it cannot: " + OIIO::geterror());
    const bool png = format == "png";
    OIIO::ImageSpec spec(image.width(), image.height(), 3, png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");  // lossless in both
    spec.attribute("oiio:ColorSpace", png ? "sRGB" : "Linear");
    const std::vector<std::uint8_t> bytes = png ? srgb_bytes(image) : std::vector<std::uint8_t>{};
    const void* pixels = png ? static_cast<const void*>(bytes.data()) : image.pixels().data();
    const bool written = output->open(path.string(), spec) && output->write_image(spec.format, pixels);
    if (!output->close() || !written)
        throw Error({path.string()}, "a place that can be written", reason(output->geterror()));
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
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);  // colours as they stand in the file; alpha is not looked at
    OIIO::ImageSpec spec;
    const auto input = OIIO::ImageInput::create(format);
    if (!input) throw Error({path.string()}, "OpenImageIO to read " + format, "that it cannot: " + OIIO::geterror());
    if (!input->open(path.string(), spec, wish))
        throw Error({path.string()}, "a readable picture", reason(input->geterror()));
    refuse_size(spec, path);
    const auto channels = color_channels(spec, path);
    std::vector<float> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, values.data()))
        throw Error({path.string()}, "a whole picture", reason(input->geterror()));
    return image_of(values, spec, channels, format);
}

void write_image(const Image& image, const fs::path& path) {
    const std::string extension = path.extension().string();
    if (extension != ".exr" && extension != ".png")
        throw Error({path.string()}, "a name ending in .exr or .png", "'" + extension + "'");
    if (image.pixels().empty()) throw Error({path.string()}, "a picture of at least one pixel", "an empty one");
    refuse_non_finite(image, path);
    write_file_with(
        path, [&](const fs::path& beside) { write_pixels(beside, image, extension == ".png" ? "png" : "openexr"); });
}

std::string write_picture(const Image& image, const fs::path& folder, const std::string& name) {
    write_image(image, folder / (name + ".exr"));
    write_image(image, folder / (name + ".png"));
    return name + ".png";
}

}  // namespace raylab
