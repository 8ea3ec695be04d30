#pragma once

#include "raylab/base/large_pages.h"

#include <cassert>
#include <cstddef>

namespace raylab {

/// One pixel of a stored picture: linear RGB, Rec. 709 primaries. (Without initial values, so that a picture is not set
/// to them before it is drawn.)
struct Pixel {
    float r, g, b;

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// A picture of floats: row 0 is the top, column 0 the left.
class Image {
public:
    Image() = default;
    Image(int width, int height, Pixel fill = {})
        : width_(width), height_(height), pixels_(pixel_count(width, height), fill) {}
    /// Its pixels are not set: for a picture of which each is drawn, by several threads.
    static Image unset(int width, int height) {
        Image image;
        image.width_ = width;
        image.height_ = height;
        image.pixels_ = LargeArray<Pixel>(pixel_count(width, height));
        return image;
    }

    int width() const { return width_; }
    int height() const { return height_; }
    Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }
    const LargeArray<Pixel>& pixels() const { return pixels_; }

private:
    static std::size_t pixel_count(int width, int height) {
        assert(width >= 0 && height >= 0);
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    std::size_t index(int x, int y) const {
        assert(x >= 0 && x < width_ && y >= 0 && y < height_);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_ = 0, height_ = 0;
    LargeArray<Pixel> pixels_;
};

}  // namespace raylab
