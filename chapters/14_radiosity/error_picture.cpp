#include "error_picture.h"

#include "raylab/image/color_map.h"
#include "raylab/image/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::cornell {

namespace {

constexpr double last_color_error = 0.5;  // of the mean: what the last colour stands for
constexpr int scale_height = 44;
constexpr int fewest_for_all_ticks = 240;  // pixels of width: on less their numbers would touch

double mean_of(const Pixel& pixel) { return (pixel.r + pixel.g + pixel.b) / 3.0; }

// The mean over what is no light: emitters would make everything else look right.
double mean_of(const Image& image) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (const double value = mean_of(image.at(x, y)); value > 0 && value < 1.5) {
                sum += value;
                ++count;
            }
    return sum / count;
}

void draw_scale(Image& image, int top) {
    const double left = 20, width = image.width() - 2 * left;
    for (int x = 0; x < static_cast<int>(width); ++x)
        for (int y = 0; y < 14; ++y) image.at(static_cast<int>(left) + x, top + y) = heat_color(x / width);
    for (const double tick : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}) {
        const bool is_end = tick == 0 || tick == last_color_error;
        if (!is_end && image.width() < fewest_for_all_ticks) continue;
        const Anchor anchor = tick == 0 ? Anchor::left : tick == last_color_error ? Anchor::right : Anchor::center;
        draw_text(image, {left + width * tick / last_color_error, top + 34.0}, 10,
                  fmt::format("{}{:g} %", tick == last_color_error ? "≥ " : "", 100 * tick), ink::black, anchor);
    }
}

}  // namespace

Image error_picture(const Image& picture, const Image& truth) {
    const double mean = mean_of(truth);
    Image image(picture.width(), picture.height() + scale_height);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            if (y >= picture.height())
                image.at(x, y) = ink::white;
            else
                image.at(x, y) = heat_color(std::min(
                    1.0, std::abs(mean_of(picture.at(x, y)) - mean_of(truth.at(x, y))) / mean / last_color_error));
        }
    draw_scale(image, picture.height() + 4);
    return image;
}

}  // namespace raylab::cornell
