#include "raylab/image/draw.h"

#include "raylab/image/color.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace ink {
const Pixel black{0, 0, 0}, white{1, 1, 1},
    grey = pixel_from_srgb(128, 128, 128), orange = pixel_from_srgb(230, 159, 0),
    sky_blue = pixel_from_srgb(86, 180, 233), green = pixel_from_srgb(0, 158, 115),
    yellow = pixel_from_srgb(240, 228, 66), blue = pixel_from_srgb(0, 114, 178),
    vermilion = pixel_from_srgb(213, 94, 0), purple = pixel_from_srgb(204, 121, 167);
}

namespace {

Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
Point2 operator*(double s, Point2 a) { return {s * a.x, s * a.y}; }
double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }

// Paints the points that are at most `reach` away from a figure; distance(p) is the distance of a point, negative
// inside. At the outline the coverage falls from 1 to 0 over the width of one pixel.
template <class Distance>
void paint(Image& image, Point2 low, Point2 high, double reach, const Pixel& color, const Distance& distance) {
    const auto first = [&](double edge) { return std::max(0, static_cast<int>(std::floor(edge - reach - 1))); };
    const int last_x = std::min(image.width() - 1, static_cast<int>(std::ceil(high.x + reach + 1)));
    const int last_y = std::min(image.height() - 1, static_cast<int>(std::ceil(high.y + reach + 1)));
    for (int y = first(low.y); y <= last_y; ++y)
        for (int x = first(low.x); x <= last_x; ++x) {
            const double cover = std::clamp(reach + 0.5 - distance(Point2{x + 0.5, y + 0.5}), 0.0, 1.0);
            const auto mix = [&](float under, float over) {
                return static_cast<float>(under + cover * (over - under));
            };
            Pixel& pixel = image.at(x, y);
            pixel = {mix(pixel.r, color.r), mix(pixel.g, color.g), mix(pixel.b, color.b)};
        }
}

}  // namespace

void draw_line(Image& image, Point2 from, Point2 to, double width, const Pixel& color) {
    const Point2 low{std::min(from.x, to.x), std::min(from.y, to.y)},
        high{std::max(from.x, to.x), std::max(from.y, to.y)};
    const Point2 along = to - from;
    paint(image, low, high, width / 2, color, [&](Point2 p) {
        const double squared = dot(along, along);
        const double s = squared > 0 ? std::clamp(dot(p - from, along) / squared, 0.0, 1.0) : 0.0;
        const Point2 away = p - (from + s * along);
        return std::hypot(away.x, away.y);
    });
}

void draw_arrow(Image& image, Point2 from, Point2 to, double width, const Pixel& color) {
    draw_line(image, from, to, width, color);
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) return;
    const Point2 back = (1 / length) * (from - to), side{-back.y, back.x};
    const double head = 2 + 3.5 * width;
    draw_line(image, to, to + head * (back + 0.45 * side), width, color);
    draw_line(image, to, to + head * (back - 0.45 * side), width, color);
}

void draw_disk(Image& image, Point2 center, double radius, const Pixel& color) {
    paint(image, center, center, radius, color, [&](Point2 p) { return std::hypot(p.x - center.x, p.y - center.y); });
}

void draw_circle(Image& image, Point2 center, double radius, double width, const Pixel& color) {
    const Point2 corner{radius, radius};
    paint(image, center - corner, center + corner, width / 2, color,
          [&](Point2 p) { return std::abs(std::hypot(p.x - center.x, p.y - center.y) - radius); });
}

void draw_cross(Image& image, Point2 center, double size, double width, const Pixel& color) {
    const Point2 down{size / 2, size / 2}, up{size / 2, -size / 2};
    draw_line(image, center - down, center + down, width, color);
    draw_line(image, center - up, center + up, width, color);
}

void draw_rectangle(Image& image, Point2 from, Point2 to, double width, const Pixel& color) {
    const Point2 corners[] = {from, {to.x, from.y}, to, {from.x, to.y}};
    for (std::size_t i = 0; i < 4; ++i) draw_line(image, corners[i], corners[(i + 1) % 4], width, color);
}

void fill_convex(Image& image, const std::vector<Point2>& corners, const Pixel& color) {
    if (corners.size() < 3) return;
    Point2 low = corners[0], high = corners[0];
    double twice_area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point2 a = corners[i], b = corners[(i + 1) % corners.size()];
        low = {std::min(low.x, a.x), std::min(low.y, a.y)};
        high = {std::max(high.x, a.x), std::max(high.y, a.y)};
        twice_area += a.x * b.y - a.y * b.x;
    }
    const double turn = twice_area < 0 ? -1 : 1;
    paint(image, low, high, 0, color, [&](Point2 p) {  // the largest of the signed distances from the edges
        double outside = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point2 edge = corners[(i + 1) % corners.size()] - corners[i], to_p = p - corners[i];
            const double length = std::hypot(edge.x, edge.y);
            if (length > 0) outside = std::max(outside, turn * (edge.y * to_p.x - edge.x * to_p.y) / length);
        }
        return outside;
    });
}

Image enlarged(const Image& image, int factor) {
    Image result(image.width() * factor, image.height() * factor);
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x) result.at(x, y) = image.at(x / factor, y / factor);
    return result;
}

Image cropped(const Image& image, int x, int y, int width, int height) {
    const int x0 = std::clamp(x, 0, image.width()), y0 = std::clamp(y, 0, image.height());
    const int x1 = std::clamp(x + width, x0, image.width()), y1 = std::clamp(y + height, y0, image.height());
    Image result(x1 - x0, y1 - y0);
    for (int row = y0; row < y1; ++row)
        for (int column = x0; column < x1; ++column) result.at(column - x0, row - y0) = image.at(column, row);
    return result;
}

Image side_by_side(const std::vector<Image>& images, int gap, const Pixel& color) {
    int width = -gap, height = 0;
    for (const Image& image : images) {
        width += image.width() + gap;
        height = std::max(height, image.height());
    }
    Image result(std::max(0, width), height, color);
    int left = 0;
    for (const Image& image : images) {
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) result.at(left + x, y) = image.at(x, y);
        left += image.width() + gap;
    }
    return result;
}

Image with_caption(const Image& image, const std::string& text, double height) {
    const int strip = static_cast<int>(std::ceil(2.2 * height));
    Image result(image.width(), image.height() + strip, ink::white);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) result.at(x, y) = image.at(x, y);
    draw_text(result, {image.width() / 2.0, image.height() + 1.6 * height}, height, text, ink::black, Anchor::center);
    return result;
}

}  // namespace raylab
