#include "pixel_inset.h"

#include "raylab/image/draw.h"
#include "raylab/image/picture_files/files.h"

#include <algorithm>

namespace raylab {

namespace {

constexpr int longest_side = 320;

ImageSize reduced(const ImageSize& size) {
    const double factor = 1.0 * longest_side / std::max(size.width, size.height);
    const auto side = [&](int pixels) { return std::max(1, static_cast<int>(factor * pixels)); };
    return {side(size.width), side(size.height)};
}

}  // namespace

std::string pixel_inset(const AskedPicture& picture, const PixelSample& pixel) {
    const ImageSize large = picture.frame.image, size = reduced(large);
    CameraFrame frame = picture.frame;
    frame.image = size;
    const auto accelerator = make_accelerator("auto", picture.scene);  // without the large picture's item buffer
    Image image = whitted_picture(picture.scene, *accelerator, frame, picture.options);
    const Point2 at{(pixel.x + 0.5) * size.width / large.width, (pixel.y + 0.5) * size.height / large.height};
    draw_circle(image, at, 9, 5, ink::black);  // a white ring with a black rim is seen on any ground
    draw_circle(image, at, 9, 2.5, ink::white);
    return png_bytes(image);
}

}  // namespace raylab
