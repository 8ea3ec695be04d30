#pragma once

#include "raylab/report/plane/plane_drawing.h"

#include <string>
#include <vector>

namespace raylab {

/// Okabe and Ito's colours (2008), which differ for colour-blind eyes too, and pale ones for areas below lines.
namespace plane_ink {
inline constexpr const char *black = "#000000", *grey = "#6b6b6b", *blue = "#0072b2", *orange = "#e69f00",
                            *green = "#009e73", *vermilion = "#d55e00", *purple = "#a3548a", *pale_grey = "#f2f2f4",
                            *pale_blue = "#e3f0f8", *pale_orange = "#fdecc8", *pale_green = "#d9f0e8",
                            *light_grey = "#d0d0d6";

using Dash = PlaneStyle::Dash;
using enum PlaneStyle::Dash;

/// A line, without anything inside.
inline PlaneStyle stroke(const std::string& color, double width = 2.5, Dash dash = solid) {
    return {.line = color, .width = width, .dash = dash};
}
/// The inside alone.
inline PlaneStyle filled(const std::string& color) { return {.line = "", .fill = color}; }
}  // namespace plane_ink

/// How words stand beside their point.
struct PlaneWords {
    Point2 aside{0, 0};  // in pixels, with y downward
    Anchor anchor = Anchor::left;
    std::string color = "#222222";
    double height = 12;            // of a capital, in pixels
    std::string halo = "#ffffff";  // empty: none
};

/// The marks of a drawing that is made by hand, from the lowest to the topmost.
class PlaneSketch {
public:
    void line(PlanePoint from, PlanePoint to, const PlaneStyle& style = {});
    void path(const std::vector<PlanePoint>& points, const PlaneStyle& style = {});
    void polygon(const std::vector<PlanePoint>& corners, const PlaneStyle& style = {});
    void rectangle(PlanePoint low, PlanePoint high, const PlaneStyle& style = {});
    void circle(PlanePoint center, double radius, const PlaneStyle& style = {});
    void arrow(PlanePoint from, PlanePoint to, const PlaneStyle& style = {});
    void dot(PlanePoint at, double pixels, const std::string& color = plane_ink::black);
    void words(PlanePoint at, const std::string& words, const PlaneWords& how = {});
    /// Words without a rim.
    void text(PlanePoint at, const std::string& words, const std::string& color = plane_ink::black,
              Anchor anchor = Anchor::left);
    /// A small light.
    void light(PlanePoint at, const std::string& color = "#ffd93b");
    /// An angle at the origin, between two directions, with its name beside it.
    void angle(PlanePoint from, PlanePoint to, double radius, const std::string& name);
    void add(const PlaneFigure& figure, const PlaneStyle& style = {});
    void add(PlaneDrawing::Mark mark);
    void add(const std::vector<PlaneDrawing::Mark>& marks);

    const std::vector<PlaneDrawing::Mark>& marks() const { return marks_; }
    /// A part of the plane, on this many pixels.
    PlaneDrawing drawing(PlanePoint low, PlanePoint high, int width, int height) const;

private:
    std::vector<PlaneDrawing::Mark> marks_;
};

}  // namespace raylab
