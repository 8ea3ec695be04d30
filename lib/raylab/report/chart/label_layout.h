#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

// Where the names of points go so that none hides another. Lengths are pixels, x to the right, y up.

namespace raylab {

struct Rectangle {
    double x0, y0, x1, y1;

    bool contains(const Rectangle& other) const;
    double overlap(const Rectangle& other) const;  // area in common
};

/// A point that wants its name beside it.
struct LabelWish {
    double x, y;           // the point
    double width, height;  // of the text
};

/// Where the text goes. `leader`: so far from its point that a thin line should lead to it.
struct PlacedLabel {
    Rectangle box;
    enum class Leader { none, line } leader = Leader::none;
    double leader_x = 0, leader_y = 0;  // where on the box the line ends
};

/// What names must keep clear of.
struct Surroundings {
    Rectangle frame;                      // outside of it: never
    std::vector<Rectangle> markers = {};  // hidden only where there is no room at all
    std::vector<Rectangle> lines = {};    // rather not
};

/// Places texts near their points, always inside the frame and clear of each other, and clear of markers and lines where
/// there is room. Earlier wishes choose first; one that finds no place gets none.
std::vector<std::optional<PlacedLabel>> place_labels(std::span<const LabelWish> wishes, const Surroundings& around);

/// Moves positions apart to at least `distance`, keeping their order and moving them as little as can be, inside
/// [low, high] where they fit. For names in a column.
std::vector<double> push_apart(std::span<const double> positions, double distance, double low, double high);

/// About how wide a text is in DejaVu Sans.
double text_width(std::string_view text, double font_size);

/// How wide a text is in DejaVu Sans Bold: hardly ever less than it is drawn, so that it can be kept inside a frame.
double bold_text_width(std::string_view text, double font_size);

}  // namespace raylab
