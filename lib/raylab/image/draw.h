#pragma once

#include "raylab/image/image.h"

#include <string>
#include <vector>

// Draws on pictures, for annotated figures. Positions are in pixels as for picture_ray(): (0, 0) is the top left corner
// of the picture, the center of pixel (i, j) is (i + 0.5, j + 0.5). Edges are antialiased; parts outside the picture
// are not drawn.

namespace raylab {

struct Point2 {
    double x, y;
};

/// Colours that differ for colour-blind eyes too. M. Okabe, K. Ito: Color Universal Design (2008).
namespace ink {
extern const Pixel black, white, grey, orange, sky_blue, green, yellow, blue, vermilion, purple;
}

/// A straight line with round ends.
void draw_line(Image& image, Point2 from, Point2 to, double width, const Pixel& color);

/// A line with an arrow head at `to`.
void draw_arrow(Image& image, Point2 from, Point2 to, double width, const Pixel& color);

void draw_disk(Image& image, Point2 center, double radius, const Pixel& color);
void draw_circle(Image& image, Point2 center, double radius, double width, const Pixel& color);
void draw_cross(Image& image, Point2 center, double size, double width, const Pixel& color);
void draw_rectangle(Image& image, Point2 from, Point2 to, double width, const Pixel& color);

/// Fills a convex polygon; its corners are in order, clockwise or not.
void fill_convex(Image& image, const std::vector<Point2>& corners, const Pixel& color);

/// The point of the text that is put at the given position.
enum class Anchor { left, center, right };

/// One line of UTF-8 in DejaVu Sans, `height` pixels from the baseline to the top of a capital; the position is on the
/// baseline. A character that the font lacks is a box, and what is no UTF-8 a question mark in a diamond.
void draw_text(Image& image, Point2 at, double height, const std::string& text, const Pixel& color,
               Anchor anchor = Anchor::left);

/// The width that draw_text() needs.
double text_width(const std::string& text, double height);

/// Makes every pixel a square of `factor` x `factor` pixels.
Image enlarged(const Image& image, int factor);

/// A rectangle of a picture; the part outside the picture is left out.
Image cropped(const Image& image, int x, int y, int width, int height);

/// Puts pictures from left to right, tops aligned, with `gap` pixels of `color` between them.
Image side_by_side(const std::vector<Image>& images, int gap = 8, const Pixel& color = {1, 1, 1});

/// Puts a line of text under a picture.
Image with_caption(const Image& image, const std::string& text, double height = 9);

}  // namespace raylab
