#pragma once

#include "flat_view.h"
#include "symptoms.h"

#include <fmt/format.h>

namespace raylab::grading::mesh_hit {

/// The triangle by its weights, with what the model says at its vertices; beside it both numbers, right and an
/// answer's.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    const Ingredients made = ingredients(given.hit);
    const auto right = truth(given);
    PlaneDrawing drawing{
        .title = "the hit in its triangle, and the brightness of each vertex",
        .low = {-1, -1.2},
        .high = {8.6, 4.2},
        .notes = {fmt::format("green: right; red: yours; seen from {}; the mixed normal is {:.3g} long",
                              side_of(given.hit) > 0 ? "its front" : "behind", glm::length(mixed(made)))}};
    const auto mark = [&](PlaneDrawing::Mark added) { drawing.marks.push_back(std::move(added)); };
    const auto text = [&](PlanePoint at, const std::string& words, const char* color) {
        mark(PlaneDrawing::Text{.at = at, .words = words, .color = color, .halo = "#ffffff"});
    };
    constexpr std::array<PlanePoint, 3> corners{{{0, 0}, {4, 0}, {2, 3.4}}};
    mark(PlaneDrawing::Figure{.shape = PlanePolygon{{corners[0], corners[1], corners[2]}},
                              .style = {.line = case_ink::given, .width = 2}});
    PlanePoint hit{0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        hit.x += made.weights[i] * corners[i].x;
        hit.y += made.weights[i] * corners[i].y;
        text({corners[i].x - 0.5, corners[i].y + (i == 2 ? 0.15 : -0.4)},
             fmt::format("{:.4g}", given.model(made.normals[i])), case_ink::given);
        text({corners[i].x - 0.5, corners[i].y + (i == 2 ? 0.5 : -0.75)}, fmt::format("weight {:.3g}", made.weights[i]),
             case_ink::faint);
    }
    mark(PlaneDrawing::Dot{hit, 6, case_ink::given});
    const auto seen = [](double x) { return std::isfinite(x) ? x : 0; };
    const double largest =
        std::max({1e-9, right.gouraud, right.phong, std::abs(seen(answer[0])), std::abs(seen(answer[1]))});
    const auto bar = [&](double x, double value, const char* color, const std::string& whose) {
        text({x - 0.35, -0.5}, whose, color);
        if (!std::isfinite(value)) return text({x - 0.35, 0.2}, "no number", color);
        mark(PlaneDrawing::Path{{{x, 0}, {x, 2.6 * value / largest}}, {.line = color, .width = 14}});
        text({x - 0.35, std::max(0.0, 2.6 * value / largest) + 0.15}, fmt::format("{:.4g}", value), color);
    };
    text({5, 3.6}, "Gouraud", case_ink::given);
    text({7, 3.6}, "Phong", case_ink::given);
    bar(5.2, right.gouraud, case_ink::right, "right");
    bar(6.0, answer[0], case_ink::yours, "yours");
    bar(7.2, right.phong, case_ink::right, "right");
    bar(8.0, answer[1], case_ink::yours, "yours");
    return drawing;
}

}  // namespace raylab::grading::mesh_hit
