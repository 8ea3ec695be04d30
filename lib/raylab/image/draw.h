#pragma once

#include "raylab/image/image.h"

#include <string>
#include <vector>

// Drawing on pictures: for annotated figures. Positions are in pixels as picture_ray() counts them: (0, 0) is the top
// left corner of the picture, the centre of pixel (i, j) is (i + 0.5, j + 0.5). Edges are smooth; what falls outside
// the picture is not drawn.

namespace raylab {

struct Point2 {
    double x, y;
};

/// Colours that stay apart for colour-blind eyes too. M. Okabe, K. Ito: Color Universal Design (2008).
namespace ink {
extern const Pixel black, white, grey, orange, sky_blue, green, yellow, blue, vermilion, purple;
}

/// A straight stroke with round ends.
void draw_line(Image& image, Point2 from, Point2 to, double width, const Pixel& color);

/// A stroke with a head at `to`.
void draw_arrow(Image& image, Point2 from, Point2 to, double width, const Pixel& color);

void draw_disk(Image& image, Point2 center, double radius, const Pixel& color);
void draw_circle(Image& image, Point2 center, double radius, double width, const Pixel& color);
void draw_cross(Image& image, Point2 center, double size, double width, const Pixel& color);
void draw_rectangle(Image& image, Point2 from, Point2 to, double width, const Pixel& color);

/// The inside of a convex polygon, its corners in order; either way round.
void fill_convex(Image& image, const std::vector<Point2>& corners, const Pixel& color);

/// Which point of the text stands at the given position.
enum class Anchor { left, center, right };

/// One line of printable ASCII in a stroke font, `height` pixels from baseline to the top of a capital; the position is
/// on the baseline. Other characters are drawn as '?'.
void draw_text(Image& image, Point2 at, double height, const std::string& text, const Pixel& color,
               Anchor anchor = Anchor::left);

/// The width that draw_text() needs.
double text_width(const std::string& text, double height);

/// Every pixel as a square of `factor` x `factor` pixels.
Image enlarged(const Image& image, int factor);

/// A rectangle of a picture: what lies outside it is not taken.
Image cropped(const Image& image, int x, int y, int width, int height);

/// Pictures from left to right, tops aligned, `gap` pixels of `color` between them.
Image side_by_side(const std::vector<Image>& images, int gap = 8, const Pixel& color = {1, 1, 1});

/// A picture with a line of text under it.
Image with_caption(const Image& image, const std::string& text, double height = 9);

}  // namespace raylab
