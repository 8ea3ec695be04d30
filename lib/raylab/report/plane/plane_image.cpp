#include "raylab/image/color.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/report/plane/plane_frame.h"

#include <string>

namespace raylab {

namespace {

Pixel color_of(const std::string& name) {  // parses "#d55e00"
    const auto code = [&](std::size_t at) { return std::stoi(name.substr(at, 2), nullptr, 16); };
    return pixel_from_srgb(code(1), code(3), code(5));
}

// A line, or the dashes of one.
void draw_stroke(Image& image, Point2 a, Point2 b, const PlaneStyle& style) {
    if (style.line.empty()) return;
    const Pixel color = color_of(style.line);
    if (style.dash == PlaneStyle::Dash::solid) return draw_line(image, a, b, style.width, color);
    const double on = style.dash == PlaneStyle::Dash::dashed ? 6 : 1,
                 off = style.dash == PlaneStyle::Dash::dashed ? 5 : 3.5;
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const auto at = [&](double s) { return Point2{std::lerp(a.x, b.x, s / length), std::lerp(a.y, b.y, s / length)}; };
    for (double s = 0; s < length; s += on + off)
        draw_line(image, at(s), at(std::min(length, s + on)), style.width, color);
}

class Painter {
public:
    Painter(Image& image, const PlaneFrame& frame) : image_(image), frame_(frame) {}

    void operator()(const PlaneDrawing::Figure& figure) {
        if (const auto* circle = std::get_if<PlaneCircle>(&figure.shape)) return paint(*circle, figure.style);
        std::vector<Point2> corners;
        for (const PlanePoint& corner : std::get<PlanePolygon>(figure.shape).corners)
            corners.push_back(frame_.at(corner));
        if (!figure.style.fill.empty()) fill_convex(image_, corners, color_of(figure.style.fill));
        for (std::size_t i = 0; i < corners.size(); ++i)
            draw_stroke(image_, corners[i], corners[(i + 1) % corners.size()], figure.style);
    }

    void operator()(const PlaneDrawing::Arrow& arrow) {
        draw_arrow(image_, frame_.at(arrow.from), frame_.at(arrow.to), arrow.style.width, color_of(arrow.style.line));
    }

    void operator()(const PlaneDrawing::Dot& dot) {
        draw_disk(image_, frame_.at(dot.at), dot.radius, color_of(dot.color));
    }

    void operator()(const PlaneDrawing::Text& text) {
        const Point2 at = frame_.at(text.at);
        draw_text(image_, {at.x + text.aside.x, at.y + text.aside.y}, text.height, text.words, color_of(text.color),
                  text.anchor);
    }

private:
    void paint(const PlaneCircle& circle, const PlaneStyle& style) {
        const Point2 center = frame_.at(circle.center);
        const double radius = frame_.pixels(circle.radius);
        if (!style.fill.empty()) draw_disk(image_, center, radius, color_of(style.fill));
        constexpr int pieces = 96;  // the circle is drawn as lines, so that it can be dashed
        for (int i = 0; i < pieces; i += style.dash == PlaneStyle::Dash::solid ? 1 : 2) {
            const auto at = [&](int k) {
                const double angle = 2 * 3.14159265358979323846 * k / pieces;
                return Point2{center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
            };
            if (!style.line.empty()) draw_line(image_, at(i), at(i + 1), style.width, color_of(style.line));
        }
    }

    Image& image_;
    const PlaneFrame& frame_;
};

}  // namespace

Image to_image(const PlaneDrawing& drawing) {
    const PlaneFrame frame(drawing);
    Image image(frame.width(), frame.height(), ink::white);
    Painter painter(image, frame);
    for (const auto& mark : drawing.marks) std::visit(painter, mark);
    for (int y = 0; y < image.height(); ++y)  // clears what reaches out of the frame
        for (int x = 0; x < image.width() && (y < frame.top() || y >= frame.bottom()); ++x) image.at(x, y) = ink::white;
    if (!drawing.title.empty()) draw_text(image, frame.title(), 1.1 * PlaneFrame::letter, drawing.title, ink::black);
    for (std::size_t line = 0; line < drawing.notes.size(); ++line)
        draw_text(image, frame.note(line), 0.85 * PlaneFrame::letter, drawing.notes[line], ink::black);
    return image;
}

}  // namespace raylab
