#pragma once

#include "raylab/base/tiles.h"
#include "raylab/image/to_pixel.h"
#include "raylab/sampling/pixel_samples.h"
#include "raylab/scene/camera.h"

#include <functional>
#include <string>

namespace raylab {

struct EyePictureOptions {
    PixelSamples samples = {};
    int threads = 0;         // 0: all cores; the picture is the same bits for any number
    std::string label = {};  // of the progress bar; empty: none
};

/// The i-th sample of a pixel as an eye ray.
inline Ray sample_ray(const CameraFrame& frame, int x, int y, const PixelSamples& samples, int i) {
    const auto pixel =
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(frame.image.width) + static_cast<std::uint64_t>(x);
    const PixelPoint at = pixel_sample(samples, pixel, i);
    return eye_ray(frame, x + at.x, y + at.y);
}

/// The mean of what `color` says along the rays through a pixel's samples.
template <class ColorOf>
Color pixel_color(const CameraFrame& frame, int x, int y, const PixelSamples& samples, ColorOf& color) {
    Color sum{0, 0, 0};
    for (int i = 0; i < samples.count(); ++i) sum += color(sample_ray(frame, x, y, samples, i));
    return sum / static_cast<double>(samples.count());
}

/// Sets every pixel of a tile to pixel(x, y), a Color. What that calls is compiled into the loop: 5 % of the picture
/// of tests/bench/mirror_and_glass.toml.
template <class PixelAt>
[[gnu::flatten]] void fill(Image& image, const Tile& tile, const PixelAt& pixel) {
    Pixel* row = &image.at(tile.x0, tile.y0);
    for (int y = tile.y0; y < tile.y1; ++y, row += image.width())
        for (int x = tile.x0; x < tile.x1; ++x) row[x - tile.x0] = to_pixel(pixel(x, y));
}

/// A picture made of eye rays. Each tile asks `for_tile(draw)` to call draw(color) with a Color(const Ray&) of its own,
/// which may keep counts.
template <class ForTile>
Image eye_picture_by_tiles(const CameraFrame& frame, const EyePictureOptions& options, const ForTile& for_tile) {
    Image image = Image::unset(frame.image.width, frame.image.height);
    const auto by_tiles = [&](const auto& pixel) {
        for_each_tile(image.width(), image.height(), options.threads, options.label, [&](Tile tile) {
            for_tile(
                [&](auto&& color) { fill(image, tile, [=, &color](int x, int y) { return pixel(x, y, color); }); });
        });
    };
    if (options.samples.count() == 1 && options.samples.pattern == SamplePattern::center)
        by_tiles([&](int x, int y, auto& color) { return color(eye_ray(frame, x + 0.5, y + 0.5)); });
    else
        by_tiles([&](int x, int y, auto& color) { return pixel_color(frame, x, y, options.samples, color); });
    return image;
}

/// The same where all tiles share one `color`, which is called from several threads.
Image eye_picture(const CameraFrame& frame, const EyePictureOptions& options,
                  const std::function<Color(const Ray&)>& color);

}  // namespace raylab
