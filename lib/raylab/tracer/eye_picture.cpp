#include "raylab/tracer/eye_picture.h"

#include "raylab/base/tiles.h"

namespace raylab {

namespace {

Color pixel_color(const CameraFrame& frame, int x, int y, const PixelSamples& samples,
                  const std::function<Color(const Ray&)>& color) {
    const auto pixel =
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(frame.image.width) + static_cast<std::uint64_t>(x);
    Color sum{0, 0, 0};
    for (int i = 0; i < samples.count(); ++i) {
        const PixelPoint at = pixel_sample(samples, pixel, i);
        sum += color(eye_ray(frame, x + at.x, y + at.y));
    }
    return sum / static_cast<double>(samples.count());
}

}  // namespace

Pixel to_pixel(const Color& color) { return {cast<float>(color.x), cast<float>(color.y), cast<float>(color.z)}; }

Image eye_picture(const CameraFrame& frame, const EyePictureOptions& options,
                  const std::function<Color(const Ray&)>& color) {
    Image image(frame.image.width, frame.image.height);
    for_each_tile(image.width(), image.height(), options.threads, options.label, [&](Tile tile) {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x)
                image.at(x, y) = to_pixel(pixel_color(frame, x, y, options.samples, color));
    });
    return image;
}

}  // namespace raylab
