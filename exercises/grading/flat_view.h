#pragma once

#include "raylab/geometry/vector.h"
#include "raylab/report/plane/plane_drawing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Cases drawn in two of their three axes, seen along the third.

namespace raylab::grading {

namespace case_ink {
inline constexpr const char* right = "#009e73";
inline constexpr const char* yours = "#d55e00";
inline constexpr const char* given = "#222222";
inline constexpr const char* faint = "#bbbbbb";
}  // namespace case_ink

/// Two axes, the first to the right, the second upward; and what is drawn so far.
class FlatView {
public:
    /// The part of the plane between these corners is shown, with a margin.
    FlatView(int right, int up, const Vec3d& low, const Vec3d& high, const std::string& title)
        : right_(right), up_(up) {
        const double margin = 0.15 * std::max(high[right] - low[right], high[up] - low[up]);
        drawing_ = {.title = title,
                    .low = {low[right] - margin, low[up] - margin},
                    .high = {high[right] + margin, high[up] + margin},
                    .notes = {std::string("green: right; red: yours; seen along ") + "xyz"[3 - right - up] + ", " +
                              "xyz"[right] + " to the right, " + "xyz"[up] + " upward"}};
    }

    /// The same of points that are x to the right and y upward; the note says what that is.
    FlatView(const Vec3d& low, const Vec3d& high, const std::string& title, const std::string& note)
        : FlatView(0, 1, low, high, title) {
        drawing_.notes = {"green: right; red: yours; " + note};
    }

    /// A convex polygon.
    void polygon(const std::vector<Vec3d>& vertices, const PlaneStyle& style) {
        PlanePolygon shown;
        for (const Vec3d& vertex : vertices) shown.corners.push_back(at(vertex));
        mark(PlaneDrawing::Figure{.shape = shown, .style = style});
    }

    void box(const Vec3d& low, const Vec3d& high, const PlaneStyle& style) {
        const PlanePoint a = at(low), b = at(high);
        mark(PlaneDrawing::Figure{.shape = PlanePolygon{{a, {b.x, a.y}, b, {a.x, b.y}}}, .style = style});
    }

    /// The part of a ray between two of its points, with an arrow at its end.
    void ray(const Vec3d& from, const Vec3d& to, PlaneStyle::Dash dash = PlaneStyle::Dash::solid) {
        mark(PlaneDrawing::Arrow{at(from), at(to), {.line = case_ink::given, .width = 1.5, .dash = dash}});
    }

    void arrow(const Vec3d& from, const Vec3d& to, const char* color) {
        mark(PlaneDrawing::Arrow{at(from), at(to), {.line = color, .width = 3}});
    }

    void dot(const Vec3d& point, const char* color, const std::string& words) {
        mark(PlaneDrawing::Dot{at(point), 5, color});
        mark(PlaneDrawing::Text{.at = at(point), .words = words, .color = color, .aside = {9, -7}, .halo = "#ffffff"});
    }

    void text(const Vec3d& point, const char* color, const std::string& words) {
        mark(PlaneDrawing::Text{
            .at = at(point), .words = words, .color = color, .anchor = Anchor::center, .halo = "#ffffff"});
    }

    PlaneDrawing drawn() const { return drawing_; }

private:
    PlanePoint at(const Vec3d& point) const { return {point[right_], point[up_]}; }
    void mark(PlaneDrawing::Mark mark) { drawing_.marks.push_back(std::move(mark)); }

    int right_, up_;
    PlaneDrawing drawing_;
};

/// The two axes along which a vector is longest, in their order.
struct TwoAxes {
    int right, up;
};
inline TwoAxes longest_axes(const Vec3d& v) {
    int shortest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(v[axis]) < std::abs(v[shortest])) shortest = axis;
    return {shortest == 0 ? 1 : 0, shortest == 2 ? 1 : 2};
}

}  // namespace raylab::grading
