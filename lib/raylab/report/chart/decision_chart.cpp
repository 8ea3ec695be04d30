#include "raylab/report/chart/decision_chart.h"

#include "raylab/report/chart/broken_axis.h"
#include "raylab/report/chart/chart_words.h"
#include "raylab/report/chart/decision_layout.h"
#include "raylab/report/chart/measurement_words.h"
#include "raylab/report/chart/share_color.h"
#include "raylab/report/experiment.h"
#include "raylab/report/method_rows.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr double axis_height = 46;
constexpr double margin = DecisionLayout::margin, row_height = DecisionLayout::row_height;
const SketchText name_text = DecisionLayout::name_text, small_text = DecisionLayout::small_text;
const SketchText tick_text{.size = 13};

/// Draws the parts, one after the other.
class DecisionChart {
public:
    explicit DecisionChart(const Experiment& experiment)
        : experiment_(experiment),
          methods_(methods_in_order(experiment)),
          workloads_(workloads_of(experiment)),
          at_(experiment, methods_),
          notes_(notes_of(), at_.width - 2 * margin),
          axis_(broken_axis_for(all_times(experiment), 0.04)),
          sketch_(at_.width, at_.bottom + axis_height + notes_.height() + 8) {}

    PlaneDrawing drawing() && {
        at_.words.draw(sketch_, margin);
        for (std::size_t w = 0; w < workloads_.size(); ++w) header(w);
        for (std::size_t m = 0; m < methods_.size(); ++m) row(m);
        for (std::size_t w = 0; w < workloads_.size(); ++w) front(w);
        time_axis();
        for (std::size_t m = 0; m < methods_.size(); ++m) times(m);
        notes_.draw(sketch_, margin, at_.bottom + axis_height);
        return std::move(sketch_).drawing();
    }

private:
    static std::vector<std::string> notes_of() {
        return {"Green: none seen. The darker, the more.",
                "Framed: on the Pareto front of its workload; no other method is less wrong and as fast.",
                "A method that is wrong in more than 1 % is on no front.",
                "Bracket: as fast as the fastest of the front, since their quartiles overlap.",
                "Best methods first: by their worst column, then by their time.",
                "Times are medians, their bars quartiles."};
    }

    static std::vector<double> all_times(const Experiment& experiment) {
        std::vector<double> times;
        for (const auto& row : experiment.rows)
            times.insert(times.end(), {row.nanoseconds.low, row.nanoseconds.median, row.nanoseconds.high});
        return times;
    }

    void header(std::size_t workload) {
        const auto cell = at_.cell(0, workload);
        const double middle = (cell.x0 + cell.x1) / 2;
        sketch_.marker(middle, at_.words.height() + 12, 5, style_of(workload));
        const auto& lines = at_.headers[workload];
        for (std::size_t i = 0; i < lines.size(); ++i) {
            auto style = small_text;
            style.anchor = Anchor::center;
            sketch_.text(middle, at_.top - 8 - 15 * static_cast<double>(lines.size() - 1 - i), lines[i], style);
        }
    }

    void row(std::size_t index) {
        const auto& method = methods_[index];
        const bool best = index == 0;
        auto style = name_text;
        if (best) style.weight = SketchText::Weight::bold;
        if (method.method == "yours") sketch_.marker(margin - 7, at_.row(index), 4, style_of_yours());
        sketch_.text(margin, at_.row(index), method.name, style);
        for (std::size_t w = 0; w < workloads_.size(); ++w) cell(index, w);
    }

    void cell(std::size_t method, std::size_t workload) {
        const auto area = at_.cell(method, workload);
        auto style = small_text;
        style.anchor = Anchor::center;
        const double x = (area.x0 + area.x1) / 2, y = (area.y0 + area.y1) / 2;
        const auto row = methods_[method].rows[workload];
        if (!row) {
            style.color = quiet_color;
            sketch_.text(x, y, "–", style);
            return;
        }
        const auto& measured = experiment_.rows[*row];
        const auto color = share_color(measured.error / 1e6);
        sketch_.rectangle(area, {.line = "", .fill = color.back}, measurement_words(experiment_, measured));
        style.color = color.text;
        sketch_.text(x, y, error_text(experiment_, measured.error), style);
    }

    /// The indices of the methods to which these measurements belong.
    std::vector<std::size_t> methods_of_rows(std::size_t workload, const std::vector<std::size_t>& rows) const {
        std::vector<std::size_t> methods;
        for (std::size_t m = 0; m < methods_.size(); ++m)
            if (const auto row = methods_[m].rows[workload]; row && std::ranges::find(rows, *row) != rows.end())
                methods.push_back(m);
        return methods;
    }

    void front(std::size_t workload) {
        for (const auto m : methods_of_rows(workload, front_of(experiment_, workloads_[workload]))) {
            auto frame = at_.cell(m, workload);
            frame = {frame.x0 + 1, frame.y0 + 1, frame.x1 - 1, frame.y1 - 1};
            sketch_.rectangle(frame, {.line = text_color, .width = 2});
        }
        const auto tied = methods_of_rows(workload, fastest_of_front(experiment_, workloads_[workload]));
        if (tied.size() < 2) return;
        const PlaneStyle style{.line = text_color, .width = 1.5};
        const double x = at_.cell(0, workload).x1, edge = x + 4;
        sketch_.line(edge, at_.row(tied.front()), edge, at_.row(tied.back()), style);
        for (const auto m : tied) sketch_.line(x, at_.row(m), edge, at_.row(m), style);
    }

    double place(double nanoseconds) const { return at_.strip + at_.strip_width * axis_.share(nanoseconds); }

    void ticks(const AxisScale& scale) {
        auto style = tick_text;
        style.anchor = Anchor::center;
        style.color = quiet_color;
        const double length = place(scale.high) - place(scale.low);
        for (const auto& tick : marks_with_room(scale, length, tick_text.size)) {
            const double x = place(tick.at);
            sketch_.line(x, at_.top, x, at_.bottom, {.line = grid_color});
            sketch_.text(x, at_.bottom + 13, tick.text, style);
        }
    }

    void time_axis() {
        for (std::size_t m = 0; m <= methods_.size(); ++m) {
            const double y = at_.row(m) - row_height / 2;
            sketch_.line(at_.strip, y, at_.strip + at_.strip_width, y, {.line = grid_color});
        }
        for (const auto* scale : axis_.scales()) ticks(*scale);
        if (axis_.beyond) {
            const double x = at_.strip + at_.strip_width * (BrokenAxis::main_share + BrokenAxis::gap_share / 2);
            for (const double aside : {-3.0, 3.0})
                sketch_.line(x + aside - 3, at_.bottom + 6, x + aside + 3, at_.bottom - 6, {.line = axis_color});
            sketch_.line(x, at_.top, x, at_.bottom, {.line = axis_color, .dash = PlaneStyle::Dash::dotted});
        }
        sketch_.text(at_.strip, at_.bottom + 33,
                     "ns a query (← faster)" + std::string(axis_.beyond ? ", axis broken" : ""), small_text);
    }

    void times(std::size_t method) {
        const auto count = static_cast<double>(workloads_.size());
        for (std::size_t w = 0; w < workloads_.size(); ++w) {
            if (!methods_[method].rows[w]) continue;
            const auto& row = experiment_.rows[*methods_[method].rows[w]];
            if (!(std::isfinite(row.nanoseconds.median) && row.nanoseconds.low > 0)) continue;
            // Each workload has a lane of its own, so that equal times do not hide each other.
            const double y = at_.row(method) + (count > 1 ? (static_cast<double>(w) / (count - 1) - 0.5) * 12 : 0);
            const auto look = style_of(w);
            sketch_.line(place(row.nanoseconds.low), y, place(row.nanoseconds.high), y,
                         {.line = look.color, .width = 1.6});
            sketch_.marker(place(row.nanoseconds.median), y, 4, look, MarkFill::filled,
                           measurement_words(experiment_, row));
        }
    }

    const Experiment& experiment_;
    std::vector<MethodRows> methods_;
    std::vector<std::string> workloads_;
    DecisionLayout at_;
    ChartNotes notes_;
    BrokenAxis axis_;
    Sketch sketch_;
};

}  // namespace

PlaneDrawing decision_chart(const Experiment& experiment) { return DecisionChart(experiment).drawing(); }

}  // namespace raylab
