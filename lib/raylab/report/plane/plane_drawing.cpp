#include "raylab/report/plane/plane_drawing.h"

#include "raylab/base/file.h"
#include "raylab/report/page/html.h"
#include "raylab/report/plane/plane_frame.h"
#include "raylab/report/plane/plane_text.h"

#include <fmt/format.h>

namespace raylab {

namespace {

std::string number(double value) { return fmt::format("{:.2f}", value); }

std::string attributes(const PlaneStyle& style) {
    std::string text = fmt::format(" fill=\"{}\"", style.fill.empty() ? "none" : style.fill);
    if (style.line.empty()) return text;
    text += fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", style.line, number(style.width));
    if (style.dash == PlaneStyle::Dash::dashed) text += " stroke-dasharray=\"6 4\"";
    if (style.dash == PlaneStyle::Dash::dotted) text += " stroke-dasharray=\"1.5 3\"";
    return text;
}

std::string attributes(const PlaneDrawing::Data& data) {
    std::string text;
    for (const auto& [name, value] : data) text += " data-" + name + "=\"" + escape_html(value) + "\"";
    return text;
}

// Writes marks as SVG elements.
class Svg {
public:
    explicit Svg(const PlaneFrame& frame) : frame_(frame) {}

    void operator()(const PlaneDrawing::Figure& figure) {
        const std::string looks = attributes(figure.style) + attributes(figure.data);
        const std::string inside = figure.tooltip.empty() ? "" : "<title>" + escape_html(figure.tooltip) + "</title>";
        if (const auto* circle = std::get_if<PlaneCircle>(&figure.shape)) {
            const Point2 center = frame_.at(circle->center);
            text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}>{}</circle>\n", number(center.x),
                                 number(center.y), number(frame_.pixels(circle->radius)), looks, inside);
            return;
        }
        std::string points;
        for (const PlanePoint& corner : std::get<PlanePolygon>(figure.shape).corners) {
            const Point2 at = frame_.at(corner);
            points += (points.empty() ? "" : " ") + number(at.x) + "," + number(at.y);
        }
        text_ +=
            fmt::format("<polygon points=\"{}\" stroke-linejoin=\"round\"{}>{}</polygon>\n", points, looks, inside);
    }

    void operator()(const PlaneDrawing::Path& path) {
        std::vector<Point2> points;
        for (const PlanePoint& point : path.points) points.push_back(frame_.at(point));
        polyline(points, path.style);
    }

    void operator()(const PlaneDrawing::Arc& arc) {
        const std::vector<Point2> points = frame_.arc(arc);
        polyline(points, arc.style);
        if (arc.tip == PlaneDrawing::Arc::Tip::arrow) head(points[points.size() - 2], points.back(), arc.style);
    }

    void operator()(const PlaneDrawing::Arrow& arrow) {
        const Point2 from = frame_.at(arrow.from), to = frame_.at(arrow.to);
        line(from, to, arrow.style);
        head(from, to, arrow.style);
    }

    void operator()(const PlaneDrawing::Dot& dot) {
        const Point2 at = frame_.at(dot.at);
        text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", number(at.x), number(at.y),
                             number(dot.radius), dot.color);
    }

    void operator()(const PlaneDrawing::Text& text) {
        const Point2 at = frame_.at(text.at);
        words({at.x + text.aside.x, at.y + text.aside.y}, text);
    }

    void words(Point2 at, const PlaneDrawing::Text& text) {
        const char* anchor = text.anchor == Anchor::left ? "start" : text.anchor == Anchor::center ? "middle" : "end";
        const double font = text.height / 0.73;  // a capital has 0.73 of DejaVu's font size
        const std::vector<PlaneTextRun> runs = plane_text_runs(text.words);
        const std::string spaces = runs.size() > 1 ? " xml:space=\"preserve\"" : "";  // those between runs
        const std::string rim =
            text.halo.empty()
                ? ""
                : fmt::format(" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                              text.halo, number(0.45 * text.height));
        text_ +=
            fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}{}{}>", number(at.x),
                        number(at.y), number(font), anchor, text.color, rim, spaces, attributes(text.data));
        double drop = 0;
        for (const PlaneTextRun& run : runs) {
            text_ += span(run, font, text.height * (run.drop() - drop));
            drop = run.drop();
        }
        text_ += "</text>\n";
    }

    const std::string& text() const { return text_; }

private:
    static std::string span(const PlaneTextRun& run, double font, double down) {
        std::string looks;
        if (run.italic) looks += " font-style=\"italic\"";
        if (run.bold) looks += " font-weight=\"bold\"";
        if (run.size() != 1) looks += fmt::format(" font-size=\"{}\"", number(font * run.size()));
        if (down != 0) looks += fmt::format(" dy=\"{}\"", number(down));
        const std::string words = escape_html(run.words);
        return looks.empty() ? words : "<tspan" + looks + ">" + words + "</tspan>";
    }

    void line(Point2 a, Point2 b, const PlaneStyle& style) {
        text_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" "
                             "stroke-linecap=\"round\"{}/>\n",
                             number(a.x), number(a.y), number(b.x), number(b.y), attributes(style));
    }

    void polyline(const std::vector<Point2>& points, PlaneStyle style) {
        style.fill.clear();
        std::string list;
        for (const Point2& at : points) list += (list.empty() ? "" : " ") + number(at.x) + "," + number(at.y);
        text_ += fmt::format("<polyline points=\"{}\" stroke-linejoin=\"round\" stroke-linecap=\"round\"{}/>\n", list,
                             attributes(style));
    }

    // The same head as in draw_arrow(); it is solid where the line is dashed.
    void head(Point2 from, Point2 to, PlaneStyle style) {
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        if (!(length > 0)) return;
        style.dash = PlaneStyle::Dash::solid;
        const double size = (3 + 3.5 * style.width) / length;
        const Point2 back{size * (from.x - to.x), size * (from.y - to.y)};
        line(to, {to.x + back.x - 0.45 * back.y, to.y + back.y + 0.45 * back.x}, style);
        line(to, {to.x + back.x + 0.45 * back.y, to.y + back.y - 0.45 * back.x}, style);
    }

    const PlaneFrame& frame_;
    std::string text_;
};

}  // namespace

std::string to_svg(const PlaneDrawing& drawing) {
    const PlaneFrame frame(drawing);
    Svg marks(frame), svg(frame);
    for (const auto& mark : drawing.marks) std::visit(marks, mark);
    if (!drawing.title.empty()) svg.words(frame.title(), {{0, 0}, drawing.title, 1.2 * PlaneFrame::letter});
    for (std::size_t line = 0; line < drawing.notes.size(); ++line)
        svg.words(frame.note(line), {{0, 0}, drawing.notes[line], 0.9 * PlaneFrame::letter});
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
               "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n<rect width=\"{0}\" height=\"{1}\" "
               "fill=\"#ffffff\"/>\n<clipPath id=\"frame\"><rect y=\"{2}\" width=\"{0}\" height=\"{3}\"/></clipPath>\n",
               frame.width(), frame.height(), number(frame.top()), number(frame.bottom() - frame.top())) +
           "<g clip-path=\"url(#frame)\">\n" + marks.text() + "</g>\n" + svg.text() + "</svg>\n";
}

void write_svg(const PlaneDrawing& drawing, const std::filesystem::path& path) { write_file(path, to_svg(drawing)); }

}  // namespace raylab
