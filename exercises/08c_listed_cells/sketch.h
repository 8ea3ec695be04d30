#pragma once

#include "flat_view.h"
#include "symptoms.h"

namespace raylab::grading::listing {

/// The polygon's image on the face's plane, as far as the face is seen: cut off beside it and behind the light.
inline std::vector<Vec3d> image_near_the_face(const Arguments& given) {
    constexpr double wide = 1.5;  // times the face
    std::vector<Vec3d> polygon;
    for (const Vec3d& corner : given.corners) {
        const auto [u, v, w] = seen_by(corner, given.face);
        polygon.emplace_back(static_cast<double>(u), static_cast<double>(v), static_cast<double>(w));
    }
    for (const int side : {0, 1, 2, 3}) {
        const auto inside = [&](const Vec3d& p) { return wide * p.z - (side % 2 == 0 ? 1 : -1) * p[side / 2]; };
        std::vector<Vec3d> left;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3d &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
            const double a = inside(here), b = inside(next);
            if (a >= 0) left.push_back(here);
            if ((a < 0) != (b < 0)) left.push_back(here + a / (a - b) * (next - here));
        }
        polygon = left;
    }
    for (Vec3d& p : polygon) p = {p.x / p.z, p.y / p.z, 0};
    return polygon;
}

/// The face with its cells, what is seen of the polygon, the right rectangle, and an answer's.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    FlatView view({-1.4, -1.4, 0}, {1.4, 1.4, 0}, "the face, its cells, and the polygon's image",
                  "columns to the right, rows upward");
    const auto line = [](double x) { return 2 * x - 1; };
    for (int i = 0; i <= given.resolution; ++i) {
        const double at = line(double(i) / given.resolution);
        const std::string ink = i == 0 || i == given.resolution ? case_ink::given : case_ink::faint;
        view.polygon({{at, -1, 0}, {at, 1, 0}}, {.line = ink});
        view.polygon({{-1, at, 0}, {1, at, 0}}, {.line = ink});
    }
    const auto image = image_near_the_face(given);
    if (!image.empty()) view.polygon(image, {.line = case_ink::given, .fill = "#cccccc", .width = 1.5});
    const auto rectangle = [&](const std::optional<CellRectangle>& cells, const char* color, double inset,
                               const std::string& nothing, double height) {
        if (!cells) return view.text({0, height, 0}, color, nothing);
        const double n = given.resolution;
        const auto border = [&](int number, double aside) {
            return std::clamp(line((number + aside) / n), -1.4, 1.4);  // an answer's may be anywhere
        };
        view.box({border(cells->first_column, inset), border(cells->first_row, inset), 0},
                 {border(cells->last_column, 1 - inset), border(cells->last_row, 1 - inset), 0},
                 {.line = color, .width = 3});
    };
    rectangle(truth(given), case_ink::right, 0.06, "right: no cell", 1.15);
    rectangle(read_cells(answer), case_ink::yours, 0.16, "yours: no cell", -1.2);
    return view.drawn();
}

}  // namespace raylab::grading::listing
