#include "raylab/report/chart/tradeoff_chart.h"

#include "raylab/report/chart/chart_words.h"
#include "raylab/report/chart/measurement_words.h"
#include "raylab/report/chart/method_legend.h"
#include "raylab/report/chart/tradeoff_names.h"
#include "raylab/report/chart/tradeoff_panels.h"
#include "raylab/report/experiment.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr double border = 16, left_border = 66, gap_x = 22, gap_y = 46, workload_height = 24, axis_room = 52;
constexpr std::size_t max_names = 20;  // more names than this hide the points: then only the front is named
const SketchText workload_text{.size = 13, .weight = SketchText::Weight::bold};
const SketchText axis_text{.size = 13}, panel_ticks{.size = 13, .color = quiet_color};

std::size_t columns_for(std::size_t panels) {
    if (panels <= 3) return panels;
    return panels == 4 ? 2 : panels <= 6 || panels == 9 ? 3 : 4;
}

/// Draws the parts, one after the other.
class TradeoffChart {
public:
    explicit TradeoffChart(const Experiment& experiment)
        : experiment_(experiment),
          all_(tradeoffs_of(experiment)),
          columns_(columns_for(all_.panels.size())),
          panel_width_(all_.panels.size() == 1 ? 620
                       : columns_ > 3          ? 270
                                               : 330),
          panel_height_(all_.panels.size() == 1 ? 430 : 230),
          width_(left_border + border + each(panel_width_, columns_, gap_x)),
          words_(experiment, width_ - 2 * border),
          notes_(notes_of(all_), width_ - 2 * border),
          legend_(experiment, width_ - 2 * border),
          sketch_(width_, legend_top() + (names_all() ? 0 : legend_.height() + 6) + notes_.height() + 8) {}

    PlaneDrawing drawing() && {
        words_.draw(sketch_, border);
        for (std::size_t i = 0; i < all_.panels.size(); ++i) panel(i);
        const double middle = left_border + (width_ - left_border - border) / 2;
        auto label = axis_text;
        label.anchor = Anchor::center;
        sketch_.text(middle, legend_top() - axis_room + 36, experiment_.error_axis + " (← more accurate)", label);
        if (!names_all()) legend_.draw(sketch_, border, legend_top());
        notes_.draw(sketch_, border, legend_top() + (names_all() ? 0 : legend_.height() + 6));
        return std::move(sketch_).drawing();
    }

private:
    static double each(double size, std::size_t count, double gap) {
        return static_cast<double>(count) * (size + gap) - gap;
    }
    static std::vector<std::string> notes_of(const Tradeoffs& all);

    std::size_t rows() const { return (all_.panels.size() + columns_ - 1) / columns_; }
    bool names_all() const { return all_.panels.size() == 1 && all_.panels.front().dots.size() <= max_names; }
    double legend_top() const {
        return words_.height() + 22 + workload_height + each(panel_height_, rows(), gap_y) + axis_room;
    }

    Rectangle frame(std::size_t index) const {
        const auto column = static_cast<double>(index % columns_), row = static_cast<double>(index / columns_);
        const double x = left_border + column * (panel_width_ + gap_x);
        const double y = words_.height() + 22 + workload_height + row * (panel_height_ + gap_y);
        return {x, y, x + panel_width_, y + panel_height_};
    }

    void panel(std::size_t index) {
        const auto area = frame(index);
        const auto& shown = all_.panels[index];
        if (index % columns_ == 0 && index == 0)
            sketch_.text(border, area.y0 - workload_height - 8, "ns a query (↓ faster)", axis_text);
        sketch_.text(area.x0, area.y0 - 12, shown.workload, workload_text);
        axes(index, area);
        steps(area, shown);
        ties(area, shown);
        for (const auto& curve : shown.curves) band(area, shown, curve);
        for (const auto& curve : shown.curves) {
            std::vector<Point2> points;
            for (const auto i : curve) points.push_back(place_of(shown.dots[i], area, all_));
            sketch_.path(points, {.line = shown.dots[curve.front()].look.color, .width = 1.2});
        }
        for (const auto& dot : shown.dots) bar(area, dot);
        draw_names(sketch_, area, shown, all_, names_all() ? NamedPoints::all : NamedPoints::front);
        for (const auto& dot : shown.dots) mark(area, dot);
    }

    void axes(std::size_t index, const Rectangle& area) {
        const bool lowest = index + columns_ >= all_.panels.size(), leftmost = index % columns_ == 0;
        auto below = panel_ticks, beside = panel_ticks;
        below.anchor = Anchor::center;
        beside.anchor = Anchor::right;
        for (const auto* scale : all_.error.scales()) {
            const double length = panel_width_ * (all_.error.share(scale->high) - all_.error.share(scale->low));
            for (const auto& tick : marks_with_room(*scale, length, panel_ticks.size)) {
                const double x = std::lerp(area.x0, area.x1, all_.error.share(tick.at));
                sketch_.line(x, area.y0, x, area.y1, {.line = grid_color});
                if (lowest) sketch_.text(x, area.y1 + 13, tick.text, below);
            }
        }
        for (const auto* scale : all_.time.scales())
            for (const auto& tick : scale->ticks) {
                const double y = std::lerp(area.y1, area.y0, all_.time.share(tick.at));
                sketch_.line(area.x0, y, area.x1, y, {.line = grid_color});
                if (leftmost) sketch_.text(area.x0 - 7, y, tick.text, beside);
            }
        sketch_.path({{area.x0, area.y0}, {area.x0, area.y1}, {area.x1, area.y1}}, {.line = axis_color});
        constexpr double at = BrokenAxis::main_share + BrokenAxis::gap_share / 2;
        if (all_.time.beyond) {
            const double y = std::lerp(area.y1, area.y0, at);
            sketch_.line(area.x0 - 6, y + 4, area.x0 + 6, y - 4, {.line = axis_color, .width = 1.6});
            sketch_.line(area.x0, y, area.x1, y, {.line = axis_color, .dash = PlaneStyle::Dash::dotted});
        }
        if (all_.error.beyond) {
            const double x = std::lerp(area.x0, area.x1, at);
            sketch_.line(x - 4, area.y1 + 6, x + 4, area.y1 - 6, {.line = axis_color, .width = 1.6});
            sketch_.line(x, area.y0, x, area.y1, {.line = axis_color, .dash = PlaneStyle::Dash::dotted});
        }
    }

    /// The Pareto front: what stands above and to the right of it is beaten.
    void steps(const Rectangle& area, const TradeoffPanel& shown) {
        std::vector<Point2> corners;
        double x = area.x0, y = area.y0;
        for (const auto& dot : shown.dots) {
            if (dot.place != Dot::Place::front) continue;
            const auto at = place_of(dot, area, all_);
            x = std::max(x, at.x);
            corners.push_back({x, y});
            y = std::max(y, at.y);  // of a tie the slower one may stand higher
            corners.push_back({x, y});
        }
        if (corners.empty()) return;
        corners.push_back({area.x1, y});
        sketch_.path(corners, {.line = "#d4d4da", .width = 5});
    }

    /// A band behind those of the front that are as fast as its fastest.
    void ties(const Rectangle& area, const TradeoffPanel& shown) {
        const auto tied = fastest_of_front(experiment_, shown.workload);
        std::vector<Point2> points;
        for (const auto& dot : shown.dots)
            if (std::ranges::find(tied, dot.row) != tied.end()) points.push_back(place_of(dot, area, all_));
        if (points.size() > 1) sketch_.path(points, {.line = "#bfc4d6", .width = 16});
    }

    /// Where a curve's errors are with 95 % confidence.
    void band(const Rectangle& area, const TradeoffPanel& shown, const std::vector<std::size_t>& curve) {
        const auto at = [&](Dot dot, double error) {
            dot.error = error;
            return place_of(dot, area, all_);
        };
        for (std::size_t i = 1; i < curve.size(); ++i) {
            const Dot &a = shown.dots[curve[i - 1]], &b = shown.dots[curve[i]];
            if (a.error_low < a.error_high || b.error_low < b.error_high)
                sketch_.area({at(a, a.error_low), at(a, a.error_high), at(b, b.error_high), at(b, b.error_low)},
                             {.line = "", .fill = tint_of(a.look.color)});
        }
    }

    /// The quartiles of the time.
    void bar(const Rectangle& area, const Dot& dot) {
        const auto [low, high] = bar_of(dot, area, all_);
        sketch_.line(low.x, low.y, high.x, high.y, line_of(dot));
    }

    void mark(const Rectangle& area, const Dot& dot) {
        const auto [x, y] = place_of(dot, area, all_);
        const PlaneStyle line = line_of(dot);
        const bool seen = dot.kind == Dot::Kind::error_seen;
        if (!seen) {
            sketch_.line(x, y, x - 20, y, line);
            sketch_.path({{x - 15, y - 4}, {x - 20, y}, {x - 15, y + 4}}, line);
        }
        sketch_.marker(x, y, 4 * dot.size, dot.look, seen ? MarkFill::filled : MarkFill::hollow,
                       measurement_words(experiment_, experiment_.rows[dot.row]));
    }

    static PlaneStyle line_of(const Dot& dot) { return {.line = dot.look.color, .width = 1.4}; }

    const Experiment& experiment_;
    Tradeoffs all_;
    std::size_t columns_;
    double panel_width_, panel_height_, width_;
    ChartWords words_;
    ChartNotes notes_;
    MethodLegend legend_;
    Sketch sketch_;
};

std::vector<std::string> TradeoffChart::notes_of(const Tradeoffs& all) {
    const bool unseen = std::ranges::any_of(all.panels, [](const TradeoffPanel& panel) {
        return std::ranges::find(panel.dots, Dot::Kind::no_error_seen, &Dot::kind) != panel.dots.end();
    });
    std::vector<std::string> notes;
    if (all.numbers.size() > 1) {
        std::string sizes = "Size:";
        for (const auto& number : all.numbers) sizes += (sizes == "Size:" ? " " : " < ") + number;
        notes.push_back(sizes + ".");
    }
    if (unseen) notes.push_back("Hollow, with an arrow: no error seen in N queries, drawn at the 95 % bound 3/N.");
    notes.push_back("Grey steps and bold names: the Pareto front.");
    notes.push_back("Joined by a band: as fast as the fastest of the front, since their quartiles overlap.");
    notes.push_back("Medians of the repeats, bars: their quartiles.");
    const bool has_bands = std::ranges::any_of(all.panels, [](const TradeoffPanel& panel) {
        return std::ranges::any_of(panel.dots, [](const Dot& dot) { return dot.error_low < dot.error_high; });
    });
    if (has_bands) notes.push_back("Bands: the errors' 95 % confidence intervals.");
    if (all.time.beyond || all.error.beyond) notes.push_back("Dotted: an axis is broken.");
    for (const auto& one : all.left_out) notes.push_back("Not drawn, since no number: " + one + ".");
    return notes;
}

}  // namespace

PlaneDrawing tradeoff_chart(const Experiment& experiment) { return TradeoffChart(experiment).drawing(); }

}  // namespace raylab
