#include "raylab/image/color.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/report/plane/plane_frame.h"
#include "raylab/report/plane/plane_text.h"

#include <string>

namespace raylab {

namespace {

Pixel color_of(const std::string& name) {  // parses "#d55e00"
    const auto code = [&](std::size_t at) { return std::stoi(name.substr(at, 2), nullptr, 16); };
    return pixel_from_srgb(code(1), code(3), code(5));
}

// A line, or the dashes of one. The first dash has begun `begun` pixels before it; returns that of a line that follows.
double draw_stroke(Image& image, Point2 a, Point2 b, const PlaneStyle& style, double begun = 0) {
    if (style.line.empty()) return 0;
    const Pixel color = color_of(style.line);
    if (style.dash == PlaneStyle::Dash::solid) {
        draw_line(image, a, b, style.width, color);
        return 0;
    }
    const double on = style.dash == PlaneStyle::Dash::dashed ? 6 : 1,
                 off = style.dash == PlaneStyle::Dash::dashed ? 5 : 3.5;
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const auto at = [&](double s) { return Point2{std::lerp(a.x, b.x, s / length), std::lerp(a.y, b.y, s / length)}; };
    double s = -begun;
    for (; s < length; s += on + off)
        if (s + on > 0) draw_line(image, at(std::max(0.0, s)), at(std::min(length, s + on)), style.width, color);
    return length - (s - on - off);
}

void draw_path(Image& image, const std::vector<Point2>& points, const PlaneStyle& style) {
    double begun = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        begun = draw_stroke(image, points[i], points[i + 1], style, begun);
}

// The words, with the first letter's left end at the given place; the stroke font has one face only.
void draw_runs(Image& image, Point2 at, const std::vector<PlaneTextRun>& runs, double height, const Pixel& color) {
    for (const PlaneTextRun& run : runs) {
        draw_text(image, {at.x, at.y + run.drop() * height}, run.size() * height, run.words, color);
        at.x += text_width(run.words, run.size() * height);
    }
}

void draw_words(Image& image, Point2 at, const PlaneDrawing::Text& text) {
    const std::vector<PlaneTextRun> runs = plane_text_runs(text.words);
    double width = 0;
    for (const PlaneTextRun& run : runs) width += text_width(run.words, run.size() * text.height);
    at.x -= text.anchor == Anchor::left ? 0 : text.anchor == Anchor::center ? width / 2 : width;
    if (!text.halo.empty())
        for (const double x : {-1.5, 0.0, 1.5})
            for (const double y : {-1.5, 0.0, 1.5})
                draw_runs(image, {at.x + x, at.y + y}, runs, text.height, color_of(text.halo));
    draw_runs(image, at, runs, text.height, color_of(text.color));
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

    void operator()(const PlaneDrawing::Path& path) {
        std::vector<Point2> points;
        for (const PlanePoint& point : path.points) points.push_back(frame_.at(point));
        draw_path(image_, points, path.style);
    }

    void operator()(const PlaneDrawing::Arc& arc) {
        const std::vector<Point2> points = frame_.arc(arc);
        draw_path(image_, points, arc.style);
        if (arc.tip == PlaneDrawing::Arc::Tip::arrow)
            draw_arrow(image_, points[points.size() - 2], points.back(), arc.style.width, color_of(arc.style.line));
    }

    void operator()(const PlaneDrawing::Arrow& arrow) {
        draw_arrow(image_, frame_.at(arrow.from), frame_.at(arrow.to), arrow.style.width, color_of(arrow.style.line));
    }

    void operator()(const PlaneDrawing::Dot& dot) {
        draw_disk(image_, frame_.at(dot.at), dot.radius, color_of(dot.color));
    }

    void operator()(const PlaneDrawing::Text& text) {
        const Point2 at = frame_.at(text.at);
        draw_words(image_, {at.x + text.aside.x, at.y + text.aside.y}, text);
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
    if (!drawing.title.empty())
        draw_words(image, frame.title(), {{0, 0}, drawing.title, 1.1 * PlaneFrame::letter, "#000000"});
    for (std::size_t line = 0; line < drawing.notes.size(); ++line)
        draw_words(image, frame.note(line), {{0, 0}, drawing.notes[line], 0.85 * PlaneFrame::letter, "#000000"});
    return image;
}

}  // namespace raylab
