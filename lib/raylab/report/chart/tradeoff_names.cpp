#include "raylab/report/chart/tradeoff_names.h"

#include "raylab/report/chart/label_layout.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

struct PixelPoint {
    double x, y;
};

PixelPoint pixel_of(const Dot& dot, const Rectangle& area, const Tradeoffs& all) {
    return {std::lerp(area.x0, area.x1, all.error.share(dot.error)),
            std::lerp(area.y0, area.y1, all.time.share(dot.time))};
}

// A line becomes a row of small obstacles.
void add_line(std::vector<Rectangle>& obstacles, const PixelPoint& from, const PixelPoint& to) {
    constexpr double step = 8;
    const auto count = std::floor(std::hypot(to.x - from.x, to.y - from.y) / step);
    for (double i = 1; i < count; ++i) {
        const double x = std::lerp(from.x, to.x, i / count), y = std::lerp(from.y, to.y, i / count);
        obstacles.push_back({x - 1, y - 1, x + 1, y + 1});
    }
}

Surroundings surroundings_of(const Rectangle& area, const TradeoffPanel& panel, const Tradeoffs& all) {
    Surroundings around{.frame = {area.x0 + 3, area.y0 + 4, area.x1 - 1, area.y1 - 2}};
    for (const auto& curve : panel.curves)
        for (std::size_t i = 1; i < curve.size(); ++i)
            add_line(around.lines, pixel_of(panel.dots[curve[i - 1]], area, all),
                     pixel_of(panel.dots[curve[i]], area, all));
    for (const auto& dot : panel.dots) {
        const auto [x, y] = pixel_of(dot, area, all);
        const double reach = dot.kind == Dot::Kind::no_error_seen ? 24 : 7;
        around.markers.push_back({x - reach, y - 7, x + 7, y + 7});
    }
    return around;
}

/// The points that are to be named. The most accurate and the fastest of the front choose their places first.
std::vector<const Dot*> named_dots(const TradeoffPanel& panel, NameStyle::Which which) {
    std::vector<const Dot*> front, behind;
    for (const auto& dot : panel.dots) (dot.place == Dot::Place::front ? front : behind).push_back(&dot);
    if (front.size() > 2) std::rotate(front.begin() + 1, front.end() - 1, front.end());
    if (which == NameStyle::Which::all) front.insert(front.end(), behind.begin(), behind.end());
    return front;
}

}  // namespace

std::string tradeoff_names(const Canvas& canvas, const Rectangle& area, const TradeoffPanel& panel,
                           const Tradeoffs& all, const NameStyle& style) {
    const double font = style.font;
    const auto named = named_dots(panel, style.which);
    std::vector<LabelRequest> requests;
    for (const auto* dot : named) {
        const auto [x, y] = pixel_of(*dot, area, all);
        const auto width_of = dot->place == Dot::Place::front ? bold_text_width : text_width;
        requests.push_back({x, y, width_of(dot->name, font), font + 2});
    }
    const auto labels = place_labels(requests, surroundings_of(area, panel, all));
    std::string script;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!labels[i]) continue;
        const auto& label = *labels[i];
        const bool front = named[i]->place == Dot::Place::front;
        if (label.leader == PlacedLabel::Leader::line)
            script += line_at(canvas, requests[i].x, requests[i].y, label.leader_x, label.leader_y, "#b0b0b8", 0.8);
        script += text_at(canvas, label.box.x0, (label.box.y0 + label.box.y1) / 2, named[i]->name,
                          {.size = font,
                           .weight = front ? TextStyle::Weight::bold : TextStyle::Weight::regular,
                           .color = front ? text_color : "#55555e",
                           .ground = TextStyle::Ground::paper});
    }
    return script;
}

}  // namespace raylab
