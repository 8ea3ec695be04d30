#include "raylab/report/chart/gnuplot_canvas.h"

#include "raylab/report/chart/gnuplot.h"

#include <fmt/format.h>

namespace raylab {

namespace {

std::string screen(const Canvas& canvas, double x, double y) {
    return fmt::format("screen {:.5f}, screen {:.5f}", x / canvas.width, y / canvas.height);
}

std::string anchor_word(TextStyle::Anchor anchor) {
    return anchor == TextStyle::Anchor::left ? "left" : anchor == TextStyle::Anchor::center ? "center" : "right";
}

std::string axis_script(const std::string& name, const AxisScale& scale, TickText text) {
    std::string script = (scale.kind == AxisKind::logarithmic ? "set logscale " : "unset logscale ") + name + "\n" +
                         fmt::format("set {}range [{}:{}]\nset {}tics scale 0 (", name, scale.low, scale.high, name);
    for (std::size_t i = 0; i < scale.ticks.size(); ++i)
        script += (i > 0 ? ", " : "") + gnuplot_text(text == TickText::shown ? scale.ticks[i].text : "") + " " +
                  gnuplot_number(scale.ticks[i].at);
    return script + ") noenhanced textcolor rgb '" + std::string(quiet_color) + "'\n";
}

AxisScale with_room(AxisScale scale, double length) {
    constexpr double font = 14;  // the terminal's font size
    scale.ticks = marks_with_room(scale, length, font);
    return scale;
}

}  // namespace

std::string text_at(const Canvas& canvas, double x, double y, const std::string& text, const TextStyle& style) {
    // Words in SVG can be bold only in enhanced text, where every character of its grammar must be escaped.
    const bool bold = style.weight == TextStyle::Weight::bold;
    return fmt::format(
        "set label {} at {} {} {} font 'DejaVu Sans,{}' {} textcolor rgb '{}' front{}\n",
        bold ? gnuplot_bold_text(text) : gnuplot_text(text), screen(canvas, x, y), anchor_word(style.anchor),
        style.turned == 0 ? "norotate" : fmt::format("rotate by {}", style.turned), style.size,
        bold ? "enhanced" : "noenhanced", style.color, style.ground == TextStyle::Ground::paper ? " boxed" : "");
}

std::string line_at(const Canvas& canvas, double x0, double y0, double x1, double y1, const std::string& color,
                    double width) {
    return fmt::format("set arrow from {} to {} nohead linecolor rgb '{}' linewidth {} front\n", screen(canvas, x0, y0),
                       screen(canvas, x1, y1), color, width);
}

int point_type(MarkerStyle::Shape shape) {
    switch (shape) {
        case MarkerStyle::Shape::circle:
            return 7;
        case MarkerStyle::Shape::square:
            return 5;
        case MarkerStyle::Shape::triangle:
            return 9;
        case MarkerStyle::Shape::diamond:
            return 13;
        case MarkerStyle::Shape::triangle_down:
            return 11;
        case MarkerStyle::Shape::pentagon:
            break;
    }
    return 15;
}

std::string marker_at(const Canvas& canvas, double x, double y, const MarkerStyle& look, double size) {
    return fmt::format("set label '' at {} point pointtype {} pointsize {}*marker linecolor rgb '{}' linewidth 1.5 "
                       "front\n",
                       screen(canvas, x, y), point_type(look.shape), size, look.color);
}

std::string panel_at(const Canvas& canvas, const Rectangle& area, const AxisScale& x, TickText x_text,
                     const AxisScale& y, TickText y_text) {
    return fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset bmargin at screen "
                       "{:.5f}\nset tmargin at screen {:.5f}\n",
                       area.x0 / canvas.width, area.x1 / canvas.width, area.y0 / canvas.height,
                       area.y1 / canvas.height) +
           "unset key\nset style textbox opaque margins 0.2,0.1 fillcolor rgb '#ffffff' noborder\nset border 3 "
           "linecolor rgb '#9a9aa2' linewidth 1\nset grid linetype 1 linecolor rgb '#e6e6ea' linewidth 1\n" +
           axis_script("x", with_room(x, area.x1 - area.x0), x_text) + axis_script("y", y, y_text);
}

}  // namespace raylab
