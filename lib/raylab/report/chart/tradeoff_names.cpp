#include "raylab/report/chart/tradeoff_names.h"

#include "raylab/report/chart/label_layout.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr double name_font = 13;

// A line becomes a row of small obstacles.
void add_line(std::vector<Rectangle>& obstacles, const Point2& from, const Point2& to) {
    constexpr double step = 8;
    const auto count = std::floor(std::hypot(to.x - from.x, to.y - from.y) / step);
    for (double i = 1; i < count; ++i) {
        const double x = std::lerp(from.x, to.x, i / count), y = std::lerp(from.y, to.y, i / count);
        obstacles.push_back({x - 1, y - 1, x + 1, y + 1});
    }
}

Surroundings surroundings_of(const Rectangle& frame, const TradeoffPanel& panel, const Tradeoffs& all) {
    Surroundings around{.frame = {frame.x0 + 3, frame.y0 + 2, frame.x1 - 1, frame.y1 - 4}};
    for (const auto& curve : panel.curves)
        for (std::size_t i = 1; i < curve.size(); ++i)
            add_line(around.lines, place_of(panel.dots[curve[i - 1]], frame, all),
                     place_of(panel.dots[curve[i]], frame, all));
    for (const auto& dot : panel.dots) {
        const auto [low, high] = bar_of(dot, frame, all);
        add_line(around.lines, low, high);
        const auto [x, y] = place_of(dot, frame, all);
        const double reach = dot.kind == Dot::Kind::no_error_seen ? 24 : 7;
        around.markers.push_back({x - reach, y - 7, x + 7, y + 7});
    }
    return around;
}

/// The points that are to be named. The most accurate and the fastest of the front choose their places first.
std::vector<const Dot*> named_dots(const TradeoffPanel& panel, NamedPoints which) {
    std::vector<const Dot*> front, behind;
    for (const auto& dot : panel.dots) (dot.place == Dot::Place::front ? front : behind).push_back(&dot);
    if (front.size() > 2) std::rotate(front.begin() + 1, front.end() - 1, front.end());
    if (which == NamedPoints::all) front.insert(front.end(), behind.begin(), behind.end());
    return front;
}

}  // namespace

Point2 place_of(const Dot& dot, const Rectangle& frame, const Tradeoffs& all) {
    return {std::lerp(frame.x0, frame.x1, all.error.share(dot.error)),
            std::lerp(frame.y1, frame.y0, all.time.share(dot.time))};
}

std::array<Point2, 2> bar_of(const Dot& dot, const Rectangle& frame, const Tradeoffs& all) {
    Dot low = dot, high = dot;
    low.time = dot.time_low;
    high.time = dot.time_high;
    return {place_of(low, frame, all), place_of(high, frame, all)};
}

void draw_names(Sketch& sketch, const Rectangle& frame, const TradeoffPanel& panel, const Tradeoffs& all,
                NamedPoints which) {
    const auto named = named_dots(panel, which);
    std::vector<LabelRequest> requests;
    for (const auto* dot : named) {
        const auto [x, y] = place_of(*dot, frame, all);
        const auto width_of = dot->place == Dot::Place::front ? bold_label_width : label_width;
        requests.push_back({x, y, width_of(dot->name, name_font), name_font + 2});
    }
    const auto labels = place_labels(requests, surroundings_of(frame, panel, all));
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!labels[i]) continue;
        const auto& label = *labels[i];
        const bool front = named[i]->place == Dot::Place::front;
        if (label.leader == PlacedLabel::Leader::line)
            sketch.line(requests[i].x, requests[i].y, label.leader_x, label.leader_y,
                        {.line = axis_color, .width = 0.8});
        sketch.text(label.box.x0, (label.box.y0 + label.box.y1) / 2, named[i]->name,
                    {.size = name_font,
                     .weight = front ? SketchText::Weight::bold : SketchText::Weight::regular,
                     .color = front ? text_color : quiet_color,
                     .ground = SketchText::Ground::paper});
    }
}

}  // namespace raylab
