#pragma once

#include "raylab/geometry/vector.h"
#include "raylab/image/image.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// What the samples of a pixel add up to.
struct PixelSums {
    Vec3d color{0, 0, 0};
    double squared_luminance = 0;
    std::uint32_t count = 0;

    void add(const Vec3d& sample);
};

/// A picture while it is being sampled: more samples may be added to it, and pictures of other samples.
class SampledImage {
public:
    SampledImage() = default;
    SampledImage(int width, int height)
        : width_(width), height_(height), sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    int width() const { return width_; }
    int height() const { return height_; }
    PixelSums& at(int x, int y) { return sums_[index(x, y)]; }
    const PixelSums& at(int x, int y) const { return sums_[index(x, y)]; }

    /// The mean of every pixel's samples; black where there are none.
    Image mean() const;

    /// The variance of a pixel's mean luminance, estimated from its samples as if they were independent: for even
    /// samples that is more than it is. Infinite for a single sample.
    double variance_of_mean(int x, int y) const;

    /// The root of the mean variance over all pixels, as a share of the mean luminance: what the error is expected to
    /// be.
    double relative_error() const;

    /// Adds another picture's samples. Both have the same size.
    void add(const SampledImage& other);

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_ = 0, height_ = 0;
    std::vector<PixelSums> sums_;
};

/// The nearest number that is the sum of two floats, which has 48 bits: files keep sums as such. A picture that was
/// stored and read again goes on with the same bits as one that was not, if both are rounded so at the same places.
inline double in_two_floats(double x) {
    const auto high = static_cast<float>(x);
    return static_cast<double>(high) + static_cast<double>(static_cast<float>(x - static_cast<double>(high)));
}

}  // namespace raylab
