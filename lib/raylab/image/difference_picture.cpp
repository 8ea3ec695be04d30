#include "raylab/image/difference_picture.h"

#include "raylab/image/color.h"
#include "raylab/image/color_map.h"
#include "raylab/image/draw.h"

#include <algorithm>

namespace raylab {

namespace {

// Small pictures are enlarged, so that pixels are visible and a caption fits.
int zoom_for(const Image& image) { return std::max(1, 240 / std::max({1, image.width(), image.height()})); }

Image finite_part(const Image& image) {
    Image result = image;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (!is_finite(image.at(x, y))) result.at(x, y) = ink::purple;
    return result;
}

// Some of the worst windows, which do not overlap.
std::vector<BadTile> shown_tiles(const std::vector<BadTile>& tiles) {
    std::vector<BadTile> shown;
    for (const BadTile& tile : tiles) {
        const auto overlaps = [&](const BadTile& other) {
            return std::abs(tile.x - other.x) < tile.width && std::abs(tile.y - other.y) < tile.height;
        };
        if (shown.size() < 20 && std::ranges::none_of(shown, overlaps)) shown.push_back(tile);
    }
    return shown;
}

// A light mark with a dark rim is visible on any background.
void mark(Image& picture, const Comparison& comparison, int zoom) {
    const auto frame = [&](const BadTile& tile, double width, const Pixel& color) {
        const Point2 from{1.0 * tile.x * zoom, 1.0 * tile.y * zoom};
        draw_rectangle(picture, from, {from.x + 1.0 * tile.width * zoom, from.y + 1.0 * tile.height * zoom}, width,
                       color);
    };
    for (const BadTile& tile : shown_tiles(comparison.bad_tiles)) {
        frame(tile, 3, ink::black);
        frame(tile, 1.2, ink::sky_blue);
    }
    for (const PixelPair& pair : comparison.worst) {
        const Point2 center{(pair.x + 0.5) * zoom, (pair.y + 0.5) * zoom};
        draw_circle(picture, center, 4 + 0.7 * zoom, 3, ink::black);
        draw_circle(picture, center, 4 + 0.7 * zoom, 1.4, ink::white);
    }
}

void cross_out(Image& picture, const std::optional<PixelAt>& pixel, int zoom) {
    if (!pixel) return;
    const Point2 center{(pixel->x + 0.5) * zoom, (pixel->y + 0.5) * zoom};
    draw_cross(picture, center, 14, 4, ink::black);
    draw_cross(picture, center, 14, 2, ink::yellow);
}

Image heat_picture(const ErrorMap& map) {
    Image result(map.width, map.height);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) result.at(x, y) = heat_color(map.at(x, y));
    return result;
}

}  // namespace

Image difference_picture(const Image& image, const Image& reference, const Comparison& comparison) {
    const int zoom = zoom_for(image), reference_zoom = zoom_for(reference);
    Image left = enlarged(finite_part(image), zoom), right = enlarged(finite_part(reference), reference_zoom);
    if (!comparison.comparable()) {
        cross_out(left, comparison.non_finite, zoom);
        cross_out(right, comparison.reference_non_finite, reference_zoom);
        return side_by_side({with_caption(left, "picture"), with_caption(right, "reference")});
    }
    Image middle = enlarged(heat_picture(flip(reference, image)), zoom);
    for (Image* picture : {&left, &middle, &right}) mark(*picture, comparison, zoom);
    return side_by_side(
        {with_caption(left, "picture"), with_caption(middle, "difference (FLIP)"), with_caption(right, "reference")});
}

}  // namespace raylab
