#include "raylab/image/sampled_image.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

double luminance_of(const Vec3d& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }  // Rec. 709

}  // namespace

void PixelSums::add(const Vec3d& sample) {
    const double y = luminance_of(sample);
    color += sample;
    squared_luminance += y * y;
    ++count;
}

Image SampledImage::mean() const {
    Image image(width_, height_);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const PixelSums& sums = at(x, y);
            if (sums.count == 0) continue;
            const Vec3d mean = sums.color / static_cast<double>(sums.count);
            image.at(x, y) = {static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(mean.z)};
        }
    return image;
}

double SampledImage::variance_of_mean(int x, int y) const {
    const PixelSums& sums = at(x, y);
    if (sums.count < 2) return std::numeric_limits<double>::infinity();
    const auto n = static_cast<double>(sums.count);
    const double mean = luminance_of(sums.color) / n;
    return std::max(0.0, sums.squared_luminance / n - mean * mean) / (n - 1);
}

double SampledImage::relative_error() const {
    double variance = 0, light = 0;
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            variance += variance_of_mean(x, y);
            light += luminance_of(at(x, y).color) / std::max(1.0, static_cast<double>(at(x, y).count));
        }
    const double pixels = static_cast<double>(width_) * height_;
    return light > 0 ? std::sqrt(variance / pixels) / (light / pixels) : 0;
}

void SampledImage::add(const SampledImage& other) {
    assert(other.width_ == width_ && other.height_ == height_);
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        sums_[i].color += other.sums_[i].color;
        sums_[i].squared_luminance += other.sums_[i].squared_luminance;
        sums_[i].count += other.sums_[i].count;
    }
}

}  // namespace raylab
