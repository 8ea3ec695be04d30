#include "raylab/image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>

namespace raylab {

namespace {

std::array<double, 3> channels(const Pixel& pixel) { return {pixel.r, pixel.g, pixel.b}; }

bool same_bits(const Pixel& a, const Pixel& b) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    return bits(a.r) == bits(b.r) && bits(a.g) == bits(b.g) && bits(a.b) == bits(b.b);
}

double largest_difference(const Pixel& a, const Pixel& b) {
    const auto p = channels(a), q = channels(b);
    return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

bool pixel_within(const Pixel& pixel, const Pixel& reference, const Tolerance& tolerance) {
    const auto p = channels(pixel), q = channels(reference);
    for (std::size_t c = 0; c < 3; ++c)
        if (!within(p[c] - q[c], q[c], tolerance)) return false;
    return true;
}

Pixel mean_of(const Image& image) {
    std::array<double, 3> sum{};
    for (const Pixel& pixel : image.pixels())
        for (std::size_t c = 0; c < 3; ++c) sum[c] += channels(pixel)[c];
    const double count = std::max(1.0, static_cast<double>(image.pixels().size()));
    return {static_cast<float>(sum[0] / count), static_cast<float>(sum[1] / count), static_cast<float>(sum[2] / count)};
}

// Computes the sums of squares and of quotients over all channels: RMSE and relative MSE.
void measure_errors(const Image& image, const Image& reference, Comparison& result) {
    double grand_mean = 0;
    for (const double mean : channels(result.reference_mean)) grand_mean += mean / 3;
    // For a black reference the floor would be 0; then the smallest number keeps 0/0 at 0.
    const double floor = std::max(0.01 * grand_mean * grand_mean, std::numeric_limits<double>::min());
    double squares = 0, relative = 0;
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const auto p = channels(image.pixels()[i]), q = channels(reference.pixels()[i]);
        for (std::size_t c = 0; c < 3; ++c) {
            const double square = (p[c] - q[c]) * (p[c] - q[c]);
            squares += square;
            relative += square / (q[c] * q[c] + floor);
        }
    }
    const double count = std::max(1.0, 3 * static_cast<double>(image.pixels().size()));
    result.rmse = std::sqrt(squares / count);
    result.relative_mse = relative / count;
}

// Finds the worst pixel of each block, because ten neighbours would tell no more than one of them.
void find_worst(const Image& image, const Image& reference, int block, Comparison& result) {
    constexpr std::size_t largest = 10;
    std::map<std::pair<int, int>, PixelPair> worst;  // by row and column of blocks
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const double error = largest_difference(image.at(x, y), reference.at(x, y));
            if (!(error > 0)) continue;
            const PixelPair pair{x, y, image.at(x, y), reference.at(x, y), error};
            const auto [place, first] = worst.emplace(std::pair{y / block, x / block}, pair);
            if (!first && error > place->second.error) place->second = pair;
        }
    for (const auto& [place, pair] : worst) result.worst.push_back(pair);
    std::ranges::stable_sort(result.worst, std::greater{}, &PixelPair::error);
    if (!result.worst.empty()) result.max_error = result.worst[0].error;
    if (result.worst.size() > largest) result.worst.erase(result.worst.begin() + largest, result.worst.end());
}

// Where windows of `tile` pixels start: half a window apart, so that no small group of pixels is split between four of
// them, and the last one at the edge, so that none is cut.
std::vector<int> starts(int length, int tile) {
    std::vector<int> result;
    for (int start = 0; start + tile < length; start += std::max(1, tile / 2)) result.push_back(start);
    result.push_back(std::max(0, length - tile));
    return result;
}

void find_bad_tiles(const std::vector<char>& over, const SamePicture& same, Comparison& result) {
    const int across = std::min(same.tile, result.width), down = std::min(same.tile, result.height);
    for (const int y0 : starts(result.height, same.tile))
        for (const int x0 : starts(result.width, same.tile)) {
            int bad = 0;
            for (int y = y0; y < y0 + down; ++y)
                for (int x = x0; x < x0 + across; ++x)
                    bad += over[static_cast<std::size_t>(y) * static_cast<std::size_t>(result.width) +
                                static_cast<std::size_t>(x)];
            const double share = static_cast<double>(bad) / (across * down);
            if (!(share <= same.tile_share)) result.bad_tiles.push_back({x0, y0, across, down, share});
        }
    std::ranges::stable_sort(result.bad_tiles, std::greater{}, &BadTile::share);
}

std::string to_text(const Pixel& pixel) { return fmt::format("{:.6g} {:.6g} {:.6g}", pixel.r, pixel.g, pixel.b); }

}  // namespace

Comparison compare(const Image& image, const Image& reference, const SamePicture& same) {
    Comparison result;
    result.width = image.width(), result.height = image.height();
    result.reference_width = reference.width(), result.reference_height = reference.height();
    result.non_finite = first_non_finite(image);
    result.reference_non_finite = first_non_finite(reference);
    if (!result.same_size()) return result;
    for (std::size_t i = 0; i < image.pixels().size(); ++i)
        result.bits_differ += !same_bits(image.pixels()[i], reference.pixels()[i]);
    if (!result.comparable() || image.pixels().empty()) return result;

    result.mean = mean_of(image);
    result.reference_mean = mean_of(reference);
    measure_errors(image, reference, result);
    find_worst(image, reference, same.tile, result);
    std::vector<char> over;
    for (std::size_t i = 0; i < image.pixels().size(); ++i)
        over.push_back(!pixel_within(image.pixels()[i], reference.pixels()[i], same.pixel));
    result.share_over = static_cast<double>(std::ranges::count(over, 1)) / static_cast<double>(over.size());
    find_bad_tiles(over, same, result);
    result.mean_flip = result.max_error > 0 ? flip(reference, image).mean() : 0;
    return result;
}

std::vector<std::string> objections(const Comparison& c, const SamePicture& same) {
    if (!c.same_size())
        return {fmt::format("the size is {} x {}, the reference's {} x {}", c.width, c.height, c.reference_width,
                            c.reference_height)};
    std::vector<std::string> found;
    const auto not_finite = [&](const std::string& whose, const std::optional<PixelAt>& pixel) {
        if (pixel)
            found.push_back(
                fmt::format("{} pixel ({}, {}) is not finite: {}", whose, pixel->x, pixel->y, to_text(pixel->value)));
    };
    not_finite("the picture's", c.non_finite);
    not_finite("the reference's", c.reference_non_finite);
    if (!found.empty()) return found;

    if (!(c.share_over <= same.outlier_share))
        found.push_back(fmt::format("{:.3g} % of the pixels are over tolerance, {:.3g} % may be", 100 * c.share_over,
                                    100 * same.outlier_share));
    if (!c.bad_tiles.empty())
        found.push_back(
            fmt::format("{} of the {} x {} windows have more than {:.3g} % of their pixels over tolerance, the worst "
                        "{:.3g} % at ({}, {})",
                        c.bad_tiles.size(), same.tile, same.tile, 100 * same.tile_share, 100 * c.bad_tiles[0].share,
                        c.bad_tiles[0].x, c.bad_tiles[0].y));
    const auto mean = channels(c.mean), reference_mean = channels(c.reference_mean);
    for (std::size_t i = 0; i < 3; ++i)
        if (!within(mean[i] - reference_mean[i], reference_mean[i], same.mean))
            found.push_back(fmt::format("the mean {} is {:.6g}, the reference's {:.6g}: more than {:.3g} % apart",
                                        std::array{"red", "green", "blue"}[i], mean[i], reference_mean[i],
                                        100 * same.mean.relative));
    return found;
}

std::vector<std::string> exact_objections(const Comparison& c) {
    if (!c.comparable()) return objections(c);
    if (c.bits_differ == 0) return {};
    return {fmt::format("{} of {} pixels have other bits", c.bits_differ, static_cast<long long>(c.width) * c.height)};
}

}  // namespace raylab
