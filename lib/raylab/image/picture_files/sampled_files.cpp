#include "raylab/image/picture_files/sampled_files.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/image/check_picture_size.h"
#include "raylab/image/exr_header.h"
#include "raylab/image/picture_files/openimageio.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> written_channels{"R",     "G",      "B",      "variance", "samples", "sum.R",  "sum.G",
                                                "sum.B", "sum.Y2", "rest.R", "rest.G",   "rest.B",  "rest.Y2"};
constexpr std::size_t samples_channel = 4, sums_channel = 5, sums_count = 4;  // of those names

// The two floats that a sum is stored as.
float high_of(double x) { return static_cast<float>(x); }
float rest_of(double x) { return static_cast<float>(x - static_cast<double>(high_of(x))); }

std::vector<float> values_of(const SampledImage& image) {
    const Image mean = image.mean();
    std::vector<float> values;
    values.reserve(written_channels.size() * mean.pixels().size());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const auto& [r, g, b] = mean.at(x, y);
            const PixelSums& sums = image.at(x, y);
            const double variance = image.variance_of_mean(x, y);
            for (const float value : {r, g, b, std::isfinite(variance) ? static_cast<float>(variance) : 0.0f,
                                      static_cast<float>(sums.count)})
                values.push_back(value);
            const std::array stored{sums.color.x, sums.color.y, sums.color.z, sums.squared_luminance};
            for (const double sum : stored) values.push_back(high_of(sum));
            for (const double sum : stored) values.push_back(rest_of(sum));
        }
    return values;
}

SampledImage image_of(int width, int height, const std::vector<float>& values, const fs::path& path) {
    SampledImage image(width, height);
    const float* pixel = values.data();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x, pixel += written_channels.size()) {
            const auto sum = [&](std::size_t i) {
                return static_cast<double>(pixel[sums_channel + i]) +
                       static_cast<double>(pixel[sums_channel + sums_count + i]);
            };
            const float count = pixel[samples_channel];
            if (!(count >= 0 && count < 1e9f && std::floor(count) == count))
                throw Error({path.string(), 0, fmt::format("pixel ({}, {})", x, y)}, "a number of samples",
                            fmt::format("{}", count));
            image.at(x, y) = {{sum(0), sum(1), sum(2)}, sum(3), static_cast<std::uint32_t>(count)};
        }
    return image;
}

}  // namespace

void write_sampled(const SampledFile& picture, const OutputFile& file) {
    const SampledImage& image = picture.image;
    const std::vector<float> values = values_of(image);
    if (const auto found = std::ranges::find_if(values, [](float x) { return !std::isfinite(x); });
        found != values.end()) {
        const auto pixel = static_cast<int>(static_cast<std::size_t>(found - values.begin()) / written_channels.size());
        throw Error(
            {file.path.string(), 0, fmt::format("pixel ({}, {})", pixel % image.width(), pixel / image.width())},
            "finite values", fmt::format("{}; nothing is written", *found));
    }
    write_file_with(file, [&](const fs::path& temporary) {
        try {
            openimageio::functions().write_exr(
                temporary.string(), {image.width(), image.height(), 1, written_channels, picture.texts}, values.data());
        } catch (const openimageio::Failure& failure) {
            throw Error({file.path.string()}, "a place that can be written", failure.reason);
        }
    });
}

SampledFile read_sampled(const fs::path& path, const MemoryLimit& limit) {
    const ExrHeader header = read_exr_header(path);
    const double bytes = 1.0 * static_cast<double>(header.width) * static_cast<double>(header.height) *
                         static_cast<double>(written_channels.size() * sizeof(float));
    check_picture_size({.width = header.width,
                        .height = header.height,
                        .file_bytes = fs::file_size(path),
                        .buffers = 3 * bytes,
                        .what = fmt::format("{} channels", header.channels)},
                       path.string(), limit);
    SampledFile found;
    std::vector<float> values;
    int width = 0, height = 0;
    const auto choose = [&](const openimageio::Picture& picture) -> openimageio::Wanted {
        if (picture.width != header.width || picture.height != header.height || picture.depth > 1)
            throw Error({path.string()}, "the size that the header says", "another");
        openimageio::Wanted wanted;
        for (const auto& name : written_channels) {
            const auto at = std::ranges::find(picture.channels, name);
            if (at == picture.channels.end())
                throw Error({path.string()}, "a picture with the sums of its samples (channel \"" + name + "\")",
                            "one without");
            wanted.channels.push_back(static_cast<int>(at - picture.channels.begin()));
        }
        width = picture.width, height = picture.height;
        values.resize(written_channels.size() * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        wanted.values = values.data();
        found.texts = picture.texts;
        return wanted;
    };
    try {
        openimageio::functions().read_exr(path.string(), choose);
    } catch (const openimageio::Failure& failure) {
        throw Error({path.string()}, "a whole picture that can be read", failure.reason);
    }
    found.image = image_of(width, height, values, path);
    return found;
}

}  // namespace raylab
