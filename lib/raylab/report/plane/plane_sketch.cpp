#include "raylab/report/plane/plane_sketch.h"

#include "raylab/report/plane/plane_angle.h"

#include <utility>

namespace raylab {

void PlaneSketch::line(PlanePoint from, PlanePoint to, const PlaneStyle& style) { path({from, to}, style); }

void PlaneSketch::path(const std::vector<PlanePoint>& points, const PlaneStyle& style) {
    marks_.emplace_back(PlaneDrawing::Path{points, style});
}

void PlaneSketch::polygon(const std::vector<PlanePoint>& corners, const PlaneStyle& style) {
    add(PlanePolygon{corners}, style);
}

void PlaneSketch::rectangle(PlanePoint low, PlanePoint high, const PlaneStyle& style) {
    polygon({low, {high.x, low.y}, high, {low.x, high.y}}, style);
}

void PlaneSketch::circle(PlanePoint center, double radius, const PlaneStyle& style) {
    add(PlaneCircle{center, radius}, style);
}

void PlaneSketch::arrow(PlanePoint from, PlanePoint to, const PlaneStyle& style) {
    marks_.emplace_back(PlaneDrawing::Arrow{from, to, style});
}

void PlaneSketch::dot(PlanePoint at, double pixels, const std::string& color) {
    marks_.emplace_back(PlaneDrawing::Dot{at, pixels, color});
}

void PlaneSketch::words(PlanePoint at, const std::string& words, const PlaneWords& how) {
    marks_.emplace_back(PlaneDrawing::Text{at, words, how.height, how.color, how.anchor, how.aside, how.halo});
}

void PlaneSketch::text(PlanePoint at, const std::string& text, const std::string& color, Anchor anchor) {
    words(at, text, {.anchor = anchor, .color = color, .halo = {}});
}

void PlaneSketch::light(PlanePoint at, const std::string& color) {
    dot(at, 9, "#444444");
    dot(at, 7, color);
}

void PlaneSketch::angle(PlanePoint from, PlanePoint to, double radius, const std::string& name) {
    const auto arc = angle_arc({0, 0}, from, to, radius, plane_ink::stroke(plane_ink::grey, 1.5));
    add({arc, beside_arc(arc, name, 16)});
}

void PlaneSketch::add(const PlaneFigure& figure, const PlaneStyle& style) {
    marks_.emplace_back(PlaneDrawing::Figure{figure, style});
}

void PlaneSketch::add(PlaneDrawing::Mark mark) { marks_.push_back(std::move(mark)); }

void PlaneSketch::add(const std::vector<PlaneDrawing::Mark>& marks) {
    marks_.insert(marks_.end(), marks.begin(), marks.end());
}

PlaneDrawing PlaneSketch::drawing(PlanePoint low, PlanePoint high, int width, int height) const {
    return {.title = "", .low = low, .high = high, .width = width, .height = height, .marks = marks_};
}

}  // namespace raylab
