#include "raylab/report/chart/sketch.h"

#include <cmath>
#include <numbers>
#include <sstream>

namespace raylab {

namespace {

constexpr double kept_free = 12;  // a drawing keeps it free on all sides

/// The corners of a marker about the origin, y down; a circle has none. All look equally large.
std::vector<Point2> corners_of(MarkerStyle::Shape shape, double reach) {
    const auto regular = [&](int count, double turn, double radius) {
        std::vector<Point2> corners;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * (turn + i) / count;
            corners.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
        }
        return corners;
    };
    switch (shape) {
        case MarkerStyle::Shape::circle:
            return {};
        case MarkerStyle::Shape::square:
            return regular(4, 0.5, 1.25 * reach);
        case MarkerStyle::Shape::triangle:
            return regular(3, 0, 1.35 * reach);
        case MarkerStyle::Shape::diamond:
            return regular(4, 0, 1.3 * reach);
        case MarkerStyle::Shape::triangle_down:
            return regular(3, 0.5, 1.35 * reach);
        case MarkerStyle::Shape::pentagon:
            return regular(5, 0, 1.15 * reach);
    }
    return {};
}

}  // namespace

Sketch::Sketch(double width, double height) : height_(std::ceil(height)) {
    drawing_.width = static_cast<int>(std::ceil(width));
    drawing_.height = static_cast<int>(height_);
    drawing_.high = {drawing_.width - 2 * kept_free, drawing_.height - 2 * kept_free};
}

PlanePoint Sketch::at(double x, double y) const { return {x - kept_free, height_ - kept_free - y}; }

void Sketch::text(double x, double y, const std::string& words, const SketchText& style) {
    const double capital = 0.73 * style.size;  // DejaVu's
    const bool bold = style.weight == SketchText::Weight::bold;
    drawing_.marks.push_back(PlaneDrawing::Text{.at = at(x, y + capital / 2),
                                                .words = bold ? "**" + words + "**" : words,
                                                .height = capital,
                                                .color = style.color,
                                                .anchor = style.anchor,
                                                .halo = style.ground == SketchText::Ground::paper ? "#ffffff" : ""});
}

void Sketch::line(double x0, double y0, double x1, double y1, const PlaneStyle& style) {
    path({{x0, y0}, {x1, y1}}, style);
}

void Sketch::path(const std::vector<Point2>& points, const PlaneStyle& style) {
    std::vector<PlanePoint> placed;
    for (const auto& point : points) placed.push_back(at(point.x, point.y));
    drawing_.marks.push_back(PlaneDrawing::Path{placed, style});
}

void Sketch::rectangle(const Rectangle& area, const PlaneStyle& style, const MarkWords& words) {
    const PlanePolygon shape{{at(area.x0, area.y0), at(area.x1, area.y0), at(area.x1, area.y1), at(area.x0, area.y1)}};
    drawing_.marks.push_back(PlaneDrawing::Figure{shape, style, words.tooltip, words.data});
}

void Sketch::area(const std::vector<Point2>& convex, const PlaneStyle& style) {
    PlanePolygon polygon;
    for (const auto& corner : convex) polygon.corners.push_back(at(corner.x, corner.y));
    drawing_.marks.push_back(PlaneDrawing::Figure{polygon, style});
}

void Sketch::marker(double x, double y, double reach, const MarkerStyle& look, MarkFill fill, const MarkWords& words) {
    const bool filled = fill == MarkFill::filled;
    const PlaneStyle style{
        .line = filled ? "#ffffff" : look.color, .fill = filled ? look.color : "#ffffff", .width = filled ? 0.7 : 1.6};
    PlaneFigure shape = PlaneCircle{at(x, y), reach};
    if (const auto corners = corners_of(look.shape, reach); !corners.empty()) {
        PlanePolygon polygon;
        for (const auto& corner : corners) polygon.corners.push_back(at(x + corner.x, y + corner.y));
        shape = polygon;
    }
    drawing_.marks.push_back(PlaneDrawing::Figure{shape, style, words.tooltip, words.data});
}

PlaneDrawing Sketch::drawing() && { return std::move(drawing_); }

std::vector<std::string> lines_in(const std::string& text, double width, const SketchText& style) {
    const auto width_of = style.weight == SketchText::Weight::bold ? bold_label_width : label_width;
    std::vector<std::string> lines = {""};
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto longer = lines.back() + (lines.back().empty() ? "" : " ") + word;
        if (lines.back().empty() || width_of(longer, style.size) <= width)
            lines.back() = longer;
        else
            lines.push_back(word);
    }
    return lines;
}

}  // namespace raylab
