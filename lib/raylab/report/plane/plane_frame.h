#pragma once

#include "raylab/geometry/degree.h"
#include "raylab/report/plane/plane_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raylab {

/// Maps a drawing's plane to pixels, with y downward: as large as fits, centred, below the title and above the notes.
class PlaneFrame {
public:
    static constexpr double letter = 10;       // the height of a capital of title and notes, in pixels
    static constexpr double line_height = 20;  // in pixels
    static constexpr double title_height = 30;

    explicit PlaneFrame(const PlaneDrawing& drawing)
        : middle_{(drawing.low.x + drawing.high.x) / 2, (drawing.low.y + drawing.high.y) / 2},
          width_(drawing.width),
          height_(drawing.height),
          top_(drawing.title.empty() ? 0 : title_height),
          notes_(line_height * static_cast<double>(drawing.notes.size()) + (drawing.notes.empty() ? 0 : 8)) {
        constexpr double margin = 12;
        const double x = drawing.high.x - drawing.low.x, y = drawing.high.y - drawing.low.y;
        scale_ = std::min(x > 0 ? (width_ - 2 * margin) / x : 1e30, y > 0 ? (height_ - 2 * margin) / y : 1e30);
        if (!(x > 0 || y > 0)) scale_ = 1;
    }

    Point2 at(PlanePoint p) const {
        return {width_ / 2.0 + scale_ * (p.x - middle_.x), top_ + height_ / 2.0 - scale_ * (p.y - middle_.y)};
    }
    double pixels(double length) const { return scale_ * length; }

    /// An arc as so many points that their lines look round.
    std::vector<Point2> arc(const PlaneDrawing::Arc& arc) const {
        constexpr double step = 2;
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(arc.to - arc.from) / step)));
        std::vector<Point2> points;
        for (int i = 0; i <= pieces; ++i) {
            const double angle = degree * std::lerp(arc.from, arc.to, i / static_cast<double>(pieces));
            points.push_back(
                at({arc.center.x + arc.radius * std::cos(angle), arc.center.y + arc.radius * std::sin(angle)}));
        }
        return points;
    }

    int width() const { return width_; }
    int height() const { return static_cast<int>(std::ceil(top_ + height_ + notes_)); }
    double top() const { return top_; }               // the top of the drawing proper, below the title
    double bottom() const { return top_ + height_; }  // its bottom, above the notes
    Point2 title() const { return {12, 0.7 * title_height}; }
    Point2 note(std::size_t line) const {
        return {12, top_ + height_ + line_height * (static_cast<double>(line) + 0.7)};
    }

private:
    PlanePoint middle_;
    int width_, height_;
    double top_, notes_, scale_;
};

}  // namespace raylab
