#pragma once

#include "raylab/image/draw.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

// A drawing in a plane, made of few kinds of marks: written as SVG, or painted as a picture.

namespace raylab {

/// A point of a drawing, in units of its own, y upward.
using PlanePoint = Point2;

struct PlaneCircle {
    PlanePoint center;
    double radius;
};

/// Convex; two corners make a stroke, one makes nothing.
struct PlanePolygon {
    std::vector<PlanePoint> corners;
};

using PlaneFigure = std::variant<PlaneCircle, PlanePolygon>;

/// How a figure or a line is drawn; an empty colour: not at all.
struct PlaneStyle {
    std::string line = "#000000";
    std::string fill = {};
    double width = 1;  // pixels
    enum class Dash { solid, dashed, dotted } dash = Dash::solid;
};

/// A drawing, its marks from the lowest to the topmost.
struct PlaneDrawing {
    struct Figure {
        PlaneFigure shape;
        PlaneStyle style;
        std::string tooltip = {};  // SVG only
    };
    struct Arrow {
        PlanePoint from, to;
        PlaneStyle style;
    };
    struct Dot {
        PlanePoint at;
        double radius;  // pixels
        std::string color;
    };
    struct Text {
        PlanePoint at;
        std::string words;
        double height = 10;  // pixels, of a capital
        std::string color = "#222222";
        Anchor anchor = Anchor::left;
        Point2 aside{0, 0};  // pixels away from there, y downward
    };
    using Mark = std::variant<Figure, Arrow, Dot, Text>;

    std::string title;                  // one line above it
    PlanePoint low{0, 0}, high{1, 1};   // what part of the plane is shown, at least
    int width = 720, height = 540;      // pixels, without title and notes
    std::vector<std::string> notes = {};  // lines below it: legend, what was left out
    std::vector<Mark> marks = {};
};

std::string to_svg(const PlaneDrawing& drawing);
void write_svg(const PlaneDrawing& drawing, const std::filesystem::path& path);

/// The same as a picture. (Letters beyond ASCII are '?' there.)
Image to_image(const PlaneDrawing& drawing);

}  // namespace raylab
