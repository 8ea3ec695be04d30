#pragma once

#include "flat_view.h"
#include "symptoms.h"

#include <fmt/format.h>

namespace raylab::grading::local {

/// The surface from the side, the ways to the viewer and to the lights by their angles from the normal; under it the
/// three channels, right and an answer's.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = arguments(question.input);
    PlaneDrawing drawing{
        .title = "angles from the normal; a light below the line is behind the surface",
        .low = {-5, -4.5},
        .high = {5, 3.6},
        .notes = {"bars: red, green and blue of the colour; the green ones are right, the red ones yours"}};
    const auto mark = [&](PlaneDrawing::Mark added) { drawing.marks.push_back(std::move(added)); };
    const auto text = [&](PlanePoint at, const std::string& words, const char* color) {
        mark(PlaneDrawing::Text{.at = at, .words = words, .color = color, .halo = "#ffffff"});
    };
    const auto arrow = [&](double cosine, double side, const std::string& words) {
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
        const PlanePoint to{3 * side * std::sin(angle), 3 * std::cos(angle)};
        mark(PlaneDrawing::Arrow{{0, 0}, to, {.line = case_ink::given, .width = 1.5}});
        text(to, words, case_ink::given);
    };
    mark(PlaneDrawing::Path{{{-3.5, 0}, {3.5, 0}}, {.line = case_ink::given, .width = 3}});
    mark(PlaneDrawing::Path{{{0, 0}, {0, 3.2}},
                            {.line = case_ink::faint, .width = 1, .dash = PlaneStyle::Dash::dashed}});
    arrow(dot(given.surface.normal, given.surface.to_viewer), 1, "viewer");
    for (std::size_t i = 0; i < given.lights.size(); ++i) {
        const auto& way = given.lights[i].way;
        const double side =
            dot(way, cross(given.surface.normal, cross(given.surface.to_viewer, given.surface.normal))) < 0 ? -1 : 1;
        arrow(dot(given.surface.normal, way) / glm::length(way), side, fmt::format("light {}", i + 1));
    }
    const Vec3d right = truth(given);
    double largest = 1e-9;
    for (int i = 0; i < 3; ++i) {
        const double said = answer[static_cast<std::size_t>(i)];
        largest = std::max({largest, std::abs(right[i]), std::isfinite(said) ? std::abs(said) : 0});
    }
    const auto bars = [&](double x, const char* color, const std::string& whose, const auto& channel) {
        text({x, -4.3}, whose, color);
        for (int i = 0; i < 3; ++i) {
            const double left = x + 0.8 * i, value = channel(i);
            if (!std::isfinite(value)) continue;
            mark(PlaneDrawing::Path{{{left, -2.8}, {left, -2.8 + 1.2 * value / largest}}, {.line = color, .width = 9}});
            text({left - 0.3, -3.7}, fmt::format("{:.3g}", value), color);
        }
    };
    bars(-3.5, case_ink::right, "right", [&](int i) { return right[i]; });
    bars(1, case_ink::yours, "yours", [&](int i) { return answer[static_cast<std::size_t>(i)]; });
    return drawing;
}

}  // namespace raylab::grading::local
