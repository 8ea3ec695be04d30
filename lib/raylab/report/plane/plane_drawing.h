#pragma once

#include "raylab/image/draw.h"

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// A drawing in a plane, made of a few kinds of marks; it is written as SVG, or painted as a picture.

namespace raylab {

/// A point of a drawing, in the drawing's own units; y points up.
using PlanePoint = Point2;

struct PlaneCircle {
    PlanePoint center;
    double radius;
};

/// A convex polygon. Two corners make a line, a single one draws nothing.
struct PlanePolygon {
    std::vector<PlanePoint> corners;
};

using PlaneFigure = std::variant<PlaneCircle, PlanePolygon>;

/// How a figure or a line is drawn; a part with an empty colour is not drawn.
struct PlaneStyle {
    std::string line = "#000000";
    std::string fill = {};
    double width = 1;  // in pixels
    enum class Dash { solid, dashed, dotted } dash = Dash::solid;
};

/// A drawing; its marks are in order from the lowest to the topmost.
struct PlaneDrawing {
    /// For a page's scripts: {"method", "watertight"} is the attribute data-method of an SVG's element.
    using Data = std::vector<std::pair<std::string, std::string>>;
    struct Figure {
        PlaneFigure shape;
        PlaneStyle style;
        std::string tooltip = {};  // shown in SVG only
        Data data = {};
    };
    struct Arrow {
        PlanePoint from, to;
        PlaneStyle style;
    };
    /// Straight lines from point to point; it is not closed, and has no inside.
    struct Path {
        std::vector<PlanePoint> points;
        PlaneStyle style;
    };
    /// A part of a circle, from one angle to another: in degrees, counter-clockwise from the right, clockwise if
    /// `to` is the smaller one.
    struct Arc {
        PlanePoint center;
        double radius;
        double from, to;
        PlaneStyle style;
        enum class Tip { none, arrow } tip = Tip::none;
    };
    struct Dot {
        PlanePoint at;
        double radius;  // in pixels
        std::string color;
    };
    struct Text {
        PlanePoint at;
        std::string words;   // with the markup of plane_text.h
        double height = 10;  // of a capital, in pixels
        std::string color = "#222222";
        Anchor anchor = Anchor::left;
        Point2 aside{0, 0};     // offset in pixels, with y downward
        std::string halo = {};  // the colour of a rim, for words that stand across lines
        Data data = {};
    };
    using Mark = std::variant<Figure, Path, Arc, Arrow, Dot, Text>;

    std::string title;                    // a line above the drawing
    PlanePoint low{0, 0}, high{1, 1};     // the part of the plane that is shown; the frame may show more
    int width = 720, height = 540;        // in pixels, without title and notes
    std::vector<std::string> notes = {};  // lines below the drawing: a legend, what was left out
    std::vector<Mark> marks = {};
};

std::string to_svg(const PlaneDrawing& drawing);
void write_svg(const PlaneDrawing& drawing, const std::filesystem::path& path);

/// Paints the drawing as a picture.
Image to_image(const PlaneDrawing& drawing);

}  // namespace raylab
