#include "raylab/report/chart/curve_chart.h"

#include "raylab/report/chart/gnuplot_canvas.h"
#include "raylab/report/chart/label_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace raylab {

namespace {

constexpr double curve_font = 14;
constexpr std::size_t max_markers = 12;  // more markers would hide their curve

// Each as large as a page shows it, so that its letters keep their size.
constexpr Canvas page{860, 500}, half_page{450, 340};

constexpr double left_room = 86, below_room = 62, above_room = 52;  // of the curves' area: numbers, labels, the title

struct Scales {
    AxisScale x, y;
};

Scales scales_of(const CurveChart& chart) {
    std::vector<double> x, y;
    for (const auto& curve : chart.curves) {
        x.insert(x.end(), curve.x.begin(), curve.x.end());
        for (const auto* values : {&curve.y, &curve.low, &curve.high})
            y.insert(y.end(), values->begin(), values->end());
    }
    return {axis_for(x, chart.x_axis, 0.03), axis_for(y, chart.y_axis, 0.06)};
}

bool can_be_drawn(double value, AxisKind axis) {
    return std::isfinite(value) && (axis == AxisKind::linear || value > 0);
}

/// The points of a curve that can be drawn, in the order of x; any other point leaves a gap.
std::string data_of(const CurveChart& chart, const Curve& curve, std::size_t index) {
    std::string lines;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const bool drawn = can_be_drawn(curve.x[i], chart.x_axis) && can_be_drawn(curve.y[i], chart.y_axis);
        const bool barred = i < curve.low.size() && can_be_drawn(curve.low[i], chart.y_axis);
        lines += !drawn ? "\n"
                        : fmt::format("{} {} {} {}\n", curve.x[i], curve.y[i], barred ? curve.low[i] : curve.y[i],
                                      barred ? curve.high[i] : curve.y[i]);
    }
    return fmt::format("# {}\n$curve{} << EOD\n{}EOD\n", gnuplot_text(curve.name), index, lines);
}

MarkerStyle look_of(const CurveChart& chart, std::size_t curve) {
    return style_of(chart.curves[curve].look.value_or(curve));
}

std::string plot_of(const CurveChart& chart) {
    std::string plot;
    const auto add = [&](const std::string& layer) { plot += (plot.empty() ? "plot " : ", \\\n     ") + layer; };
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
        const auto look = look_of(chart, i);
        const auto every = std::max<std::size_t>(1, (chart.curves[i].x.size() + max_markers - 1) / max_markers);
        if (!chart.curves[i].low.empty())
            add(fmt::format("$curve{} using 1:3:(0):($4-$3) with vectors nohead linewidth 1.2 "
                            "linecolor rgb '{}'",
                            i, look.color));
        const auto& end = chart.curves[i].measured_to;
        const std::string measured = end ? fmt::format("($1<={} ? $1 : NaN)", *end) : "1";
        add(fmt::format("$curve{} using {}:2 with lines linewidth 2 linecolor rgb '{}'", i, measured, look.color));
        if (end)
            add(fmt::format("$curve{} using ($1>={} ? $1 : NaN):2 with lines dashtype 2 linewidth 2 linecolor rgb '{}'",
                            i, *end, look.color));
        add(fmt::format("$curve{} using {}:2 every {} with points pointtype {} pointsize 1.5*marker linecolor rgb "
                        "'{}'",
                        i, measured, every, point_type(look.shape), look.color));
    }
    return (plot.empty() ? "plot NaN" : plot) + "\n";
}

/// The last drawn point of a curve, as fractions of the axes.
std::optional<std::pair<double, double>> end_of(const CurveChart& chart, const Curve& curve, const Scales& scales) {
    for (std::size_t i = curve.x.size(); i-- > 0;)
        if (can_be_drawn(curve.x[i], chart.x_axis) && can_be_drawn(curve.y[i], chart.y_axis))
            return std::pair(scales.x.share(curve.x[i]), scales.y.share(curve.y[i]));
    return std::nullopt;
}

/// Writes each curve's name, with its marker, in a column at the right, as near to the height of the curve's end as the
/// others permit.
std::string names_at_ends(const CurveChart& chart, const Canvas& canvas, const Scales& scales, const Rectangle& area) {
    std::vector<double> heights;
    std::vector<double> ends;
    for (const auto& curve : chart.curves) {
        const auto end = end_of(chart, curve, scales).value_or(std::pair(1.0, 0.5));
        ends.push_back(std::lerp(area.x0, area.x1, end.first));
        heights.push_back(std::lerp(area.y0, area.y1, end.second));
    }
    const auto column = push_apart(heights, curve_font + 6, area.y0, area.y1);
    std::string script;
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
        script += line_at(canvas, ends[i] + 6, heights[i], area.x1 + 12, column[i], "#b0b0b8", 0.8) +
                  marker_at(canvas, area.x1 + 22, column[i], look_of(chart, i), 1.3) +
                  text_at(canvas, area.x1 + 34, column[i], chart.curves[i].name, {.size = curve_font});
    }
    return script;
}

}  // namespace

GnuplotDrawing curve_drawing(const CurveChart& chart) {
    const Canvas canvas = chart.size == CurveChart::Size::page ? page : half_page;
    double longest = 0;
    for (const auto& curve : chart.curves) longest = std::max(longest, label_width(curve.name, curve_font));
    const bool named = chart.curves.size() > 1;  // a single curve needs no name: the title says what it is
    const Rectangle area{left_room, below_room, canvas.width - (named ? longest + 44 : 24), canvas.height - above_room};
    const auto scales = scales_of(chart);
    std::string script = text_at(canvas, left_room / 2, canvas.height - 24, chart.title,
                                 {.size = 16, .weight = TextStyle::Weight::bold}) +
                         text_at(canvas, (area.x0 + area.x1) / 2, 18, chart.x_label,
                                 {.size = curve_font, .anchor = TextStyle::Anchor::center}) +
                         text_at(canvas, 18, (area.y0 + area.y1) / 2, chart.y_label,
                                 {.size = curve_font, .anchor = TextStyle::Anchor::center, .turned = 90}) +
                         panel_at(canvas, area, scales.x, TickText::shown, scales.y, TickText::shown);
    if (named) script += names_at_ends(chart, canvas, scales, area);
    for (std::size_t i = 0; i < chart.curves.size(); ++i) script += data_of(chart, chart.curves[i], i);
    return {static_cast<int>(canvas.width), static_cast<int>(canvas.height), script + plot_of(chart)};
}

}  // namespace raylab
