#pragma once

#include "flat_view.h"
#include "truth.h"

#include <fmt/format.h>

namespace raylab::grading::contour {

/// Point, horizon and polygon from the side, with both shares in numbers.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const Arguments given = arguments(question.input);
    Vec3d middle{0, 0, 0};
    for (const Vec3d& vertex : given.polygon)
        middle += (vertex - given.point) / static_cast<double>(given.polygon.size());
    const double size = glm::length(middle);
    const Vec3d along = middle - dot(middle, given.normal) * given.normal;
    const Vec3d across = cross(given.normal, std::abs(given.normal.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
    const Vec3d x = glm::normalize(glm::length(along) > 1e-6 * size ? along : across);
    std::vector<Vec3d> vertices;
    for (const Vec3d& vertex : given.polygon) {
        const Vec3d way = (vertex - given.point) / size;
        vertices.push_back({dot(way, x), dot(way, given.normal), 0});
    }
    Vec3d low{-0.4, -0.4, 0}, high{1, 1, 0};
    for (const Vec3d& v : vertices) low = glm::min(low, v), high = glm::max(high, v);
    FlatView view(low, high, "the point, its horizon, and the polygon from the side", "the normal upward");
    view.polygon({{low.x, 0, 0}, {high.x, 0, 0}}, {.line = case_ink::faint, .width = 2});
    view.polygon(vertices, {.line = case_ink::given, .fill = "#e8e8e8", .width = 2});
    view.arrow({0, 0, 0}, {0, 0.4, 0}, case_ink::given);
    const double top = high.y - low.y;
    const auto share = [](double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : "no number"; };
    view.text({(low.x + high.x) / 2, low.y - 0.04 * top, 0}, case_ink::right, "right: " + share(truth(given)));
    view.text({(low.x + high.x) / 2, low.y - 0.11 * top, 0}, case_ink::yours, "yours: " + share(answer[0]));
    return view.drawn();
}

}  // namespace raylab::grading::contour
