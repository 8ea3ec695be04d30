#include "raylab/report/chart/tradeoff_chart.h"

#include "raylab/report/chart/gnuplot_canvas.h"
#include "raylab/report/chart/tradeoff_names.h"
#include "raylab/report/chart/tradeoff_panels.h"
#include "raylab/report/chart/tradeoff_strip.h"
#include "raylab/report/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr double width = 1280, title_height = 72, left = 92, right = 24, bottom = 62, gap_x = 26, gap_y = 44;
constexpr double single_height = 560, panel_height = 236;
constexpr std::size_t max_names = 20;  // more names than this hide the points: then only the front is named

std::size_t columns_for(std::size_t panels) {
    if (panels <= 3) return panels;
    if (panels == 4) return 2;
    return panels <= 6 || panels == 9 ? 3 : 4;
}

/// The places of all parts on the canvas.
struct Arrangement {
    Canvas canvas;
    std::size_t columns, rows;
    double panel_width, panel_height;
    double top;  // of the first panel, from the top

    Rectangle panel(std::size_t index) const {
        const auto column = static_cast<double>(index % columns), row = static_cast<double>(index / columns);
        const double x = left + column * (panel_width + gap_x);
        const double y = canvas.height - top - (row + 1) * panel_height - row * gap_y;
        return {x, y, x + panel_width, y + panel_height};
    }
};

Arrangement arrange(std::size_t panels, double strip_height) {
    const auto columns = columns_for(panels);
    const auto rows = (panels + columns - 1) / columns;
    const auto across = static_cast<double>(columns), down = static_cast<double>(rows);
    const double height = panels == 1 ? single_height : panel_height;
    const double top = title_height + (panels == 1 ? 12 : 38);  // room for the workload's name
    return {.canvas = {width, std::ceil(top + down * height + (down - 1) * gap_y + bottom + strip_height)},
            .columns = columns,
            .rows = rows,
            .panel_width = (width - left - right - (across - 1) * gap_x) / across,
            .panel_height = height,
            .top = top};
}

std::string point_line(const Dot& dot) {
    return fmt::format("{} {} {} {} {} {} {} 0x{} {}\n", dot.error, dot.time, dot.time_low, dot.time_high, dot.size,
                       dot.look.filled, dot.look.hollow, dot.look.color.substr(1), gnuplot_text(dot.name));
}

/// The datablocks of a panel: its points with and without errors, its curves, and the steps of its front.
std::string data_of(const TradeoffPanel& panel, const Tradeoffs& all, double arrow_share) {
    std::string seen, unseen, arrows, curves, steps;
    for (const auto& dot : panel.dots) {
        (dot.kind == Dot::Kind::error_seen ? seen : unseen) += point_line(dot);
        if (dot.kind == Dot::Kind::error_seen) continue;
        const double end = all.error.value(all.error.share(dot.error) - arrow_share);
        arrows += fmt::format("{} {} {} 0x{}\n", dot.error, dot.time, end - dot.error, dot.look.color.substr(1));
    }
    for (const auto& curve : panel.curves) {
        for (const auto i : curve) {
            const auto& dot = panel.dots[i];
            curves += fmt::format("{} {} 0x{}\n", dot.error, dot.time, dot.look.color.substr(1));
        }
        curves += "\n";
    }
    double error = 0, time = all.time.high;
    for (const auto& dot : panel.dots) {
        if (dot.place != Dot::Place::front) continue;
        error = std::max(error, dot.error);
        steps += fmt::format("{} {}\n{} {}\n", error, time, error, dot.time);
        time = dot.time;
    }
    if (!steps.empty()) steps += fmt::format("{} {}\n", all.error.high, time);
    const auto block = [](const std::string& name, const std::string& lines) {
        return "$" + name + " << EOD\n" + lines + "EOD\n";
    };
    return "# error, time, low, high, size, filled, hollow, colour, method\n" + block("seen", seen) +
           block("unseen", unseen) + block("arrows", arrows) + block("curves", curves) + block("steps", steps);
}

/// The plot command, from back to front. Empty datablocks are refused by gnuplot, so they are left out.
std::string plot_of(const TradeoffPanel& panel, double scale) {
    const auto has = [&](Dot::Kind kind) {
        return std::ranges::find(panel.dots, kind, &Dot::kind) != panel.dots.end();
    };
    const auto ps = fmt::format("($5*{:.2f}*marker)", scale);
    std::string plot;
    const auto add = [&](const std::string& layer) { plot += (plot.empty() ? "plot " : ", \\\n     ") + layer; };
    if (panel.dots.empty()) return "plot NaN\n";
    add("$steps using 1:2 with lines linewidth 5 linecolor rgb '#d4d4da'");
    add("$curves using 1:2:3 with lines linewidth 1.2 linecolor rgb variable");
    for (const std::string block : {"seen", "unseen"}) {
        if (!has(block == "seen" ? Dot::Kind::error_seen : Dot::Kind::no_error_seen)) continue;
        add("$" + block + " using 1:3:(0):($4-$3):8 with vectors nohead linewidth 1.4 linecolor rgb variable");
    }
    if (has(Dot::Kind::error_seen))
        add("$seen using 1:2:" + ps + ":6:8 with points pointtype variable pointsize variable linecolor rgb variable");
    if (has(Dot::Kind::no_error_seen)) {
        add("$arrows using 1:2:3:(0):4 with vectors head size screen 0.005,25 filled linewidth 1.4 linecolor rgb "
            "variable");
        add("$unseen using 1:2:" + ps +
            ":6:(0xffffff) with points pointtype variable pointsize variable linecolor "
            "rgb variable");
        add("$unseen using 1:2:" + ps +
            ":7:8 with points pointtype variable pointsize variable linecolor rgb "
            "variable linewidth 1.8");
    }
    return plot + "\n";
}

std::string frame_texts(const Arrangement& at, const Experiment& experiment, std::size_t workloads) {
    const auto& [w, h] = at.canvas;
    const double axis_y = at.panel(workloads - 1).y0;  // of the lowest row
    const double middle = (at.panel(0).y1 + axis_y) / 2;
    const auto methods = methods_of(experiment).size();
    auto about = fmt::format("Speed against accuracy: {} method{}", methods, methods == 1 ? "" : "s");
    about += workloads > 1 ? fmt::format(" on {} workloads", workloads) : ", " + experiment.rows.front().workload;
    return text_at(at.canvas, left, h - 30, experiment.title, {.size = 22, .weight = TextStyle::Weight::bold}) +
           text_at(at.canvas, left, h - 54, about, {.size = 14, .color = quiet}) +
           text_at(at.canvas, (left + w - right) / 2, axis_y - 44, "←  more accurate          " + experiment.error_axis,
                   {.size = 15, .anchor = TextStyle::Anchor::center}) +
           text_at(at.canvas, 26, middle, "←  faster          nanoseconds a query",
                   {.size = 15, .anchor = TextStyle::Anchor::center, .turned = 90});
}

}  // namespace

GnuplotDrawing tradeoff_drawing(const Experiment& experiment) {
    const auto all = tradeoffs_of(experiment);
    const auto count = all.panels.size();
    const Strip strip(experiment, all, width - left - right, max_names);
    const auto at = arrange(count, strip.height());
    const double scale = count == 1 ? 1.5 : 1.15, font = count == 1 ? 14 : 13;

    const bool few = count == 1 && all.panels.front().dots.size() <= max_names;
    const auto names = few ? NameStyle::Which::all : NameStyle::Which::front;

    std::string script = "set multiplot\n" + frame_texts(at, experiment, count) + strip.script(at.canvas, left);
    for (std::size_t i = 0; i < count; ++i) {
        const auto area = at.panel(i);
        const bool lowest = i + at.columns >= count, leftmost = i % at.columns == 0;
        script += panel_at(at.canvas, area, all.error, lowest ? TickText::shown : TickText::hidden, all.time,
                           leftmost ? TickText::shown : TickText::hidden);
        if (count > 1)
            script += text_at(at.canvas, area.x0, area.y1 + 14, all.panels[i].workload,
                              {.size = 15, .weight = TextStyle::Weight::bold});
        script += data_of(all.panels[i], all, 22 / at.panel_width) +
                  tradeoff_names(at.canvas, area, all.panels[i], all, {font, names}) + plot_of(all.panels[i], scale) +
                  "unset label\nunset arrow\n";
    }
    return {static_cast<int>(at.canvas.width), static_cast<int>(at.canvas.height), script + "unset multiplot\n"};
}

}  // namespace raylab
