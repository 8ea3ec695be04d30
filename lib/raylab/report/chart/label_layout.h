#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

// Places the names of points so that none hides another. Lengths are in pixels, x to the right, y up.

namespace raylab {

struct Rectangle {
    double x0, y0, x1, y1;

    bool contains(const Rectangle& other) const;
    double overlap(const Rectangle& other) const;  // the area in common
};

/// A point that is to be named, and the size of its name.
struct LabelRequest {
    double x, y;           // the point
    double width, height;  // of the text
};

/// The place of a text, and whether it is so far from its point that a thin line should lead to it.
struct PlacedLabel {
    Rectangle box;
    enum class Leader { none, line } leader = Leader::none;
    double leader_x = 0, leader_y = 0;  // where on the box the line ends
};

/// What names must not hide.
struct Surroundings {
    Rectangle frame;                      // names are never outside of it
    std::vector<Rectangle> markers = {};  // hidden only where there is no other room
    std::vector<Rectangle> lines = {};    // covered if necessary
};

/// Places texts near their points, always inside the frame and never over each other, and not over markers and lines
/// where there is room. Earlier points choose first; one that finds no place gets none.
std::vector<std::optional<PlacedLabel>> place_labels(std::span<const LabelRequest> requests,
                                                     const Surroundings& around);

/// Moves positions apart to at least `distance`, keeping their order and moving them as little as possible, inside
/// [low, high] where they fit. It is used for names in a column.
std::vector<double> push_apart(std::span<const double> positions, double distance, double low, double high);

/// The width of a text in DejaVu Sans.
double label_width(std::string_view text, double font_size);

/// The width of a text in DejaVu Sans Bold. It is hardly ever less than the drawn width, so that the text can be kept
/// inside a frame.
double bold_label_width(std::string_view text, double font_size);

}  // namespace raylab
