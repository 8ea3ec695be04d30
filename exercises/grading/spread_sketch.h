#pragma once

#include "flat_view.h"
#include "spread.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

// How points are spread, as a drawing: of a right function each ring has as many as any other.

namespace raylab::grading {

/// What is said under the drawing of both, beside the rings: a density, or nothing.
struct SpreadWords {
    std::string title, right, yours;
};

/// A disk cut into four rings of equal area, some of the points in it, and how many there are in each ring.
inline PlaneDrawing spread_sketch(const std::vector<DrawnShare>& points, const SpreadWords& words) {
    constexpr std::size_t rings = 4, apart = 31;  // every so many points are drawn
    PlaneDrawing drawing{.title = words.title,
                         .low = {-1.4, -1.75},
                         .high = {3, 1.4},
                         .notes = {"green: right; red: yours; each ring has as much area as any other"}};
    const auto mark = [&](PlaneDrawing::Mark added) { drawing.marks.push_back(std::move(added)); };
    const auto text = [&](PlanePoint at, const std::string& said, const char* color) {
        mark(PlaneDrawing::Text{.at = at, .words = said, .color = color, .halo = "#ffffff"});
    };
    const auto at = [](double inside, double turn) {
        const double radius = std::min(std::sqrt(inside), 1.35), angle = 2 * std::numbers::pi * turn;
        return PlanePoint{radius * std::cos(angle), radius * std::sin(angle)};
    };
    std::array<double, rings + 1> found{};  // the last one: outside
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [inside, turn] = points[i];
        if (!(inside >= 0) || !std::isfinite(inside + turn)) continue;
        found[std::min<std::size_t>(rings, static_cast<std::size_t>(std::min(inside * (1 - 1e-9), 2.0) * rings))] +=
            100 / static_cast<double>(points.size());
        if (i % apart == 0) mark(PlaneDrawing::Dot{at(inside, turn), 2, case_ink::yours});
    }
    for (std::size_t ring = 1; ring <= rings; ++ring) {
        std::vector<PlanePoint> circle;
        for (int i = 0; i <= 72; ++i) circle.push_back(at(static_cast<double>(ring) / rings, i / 72.0));
        mark(PlaneDrawing::Path{circle, {.line = case_ink::right, .width = ring == rings ? 3.0 : 1.5}});
    }
    text({1.5, 1.1}, "ring", case_ink::given);
    text({1.9, 1.1}, "right", case_ink::right);
    text({2.4, 1.1}, "yours", case_ink::yours);
    for (std::size_t ring = 0; ring <= rings; ++ring) {
        const double y = 0.8 - 0.3 * static_cast<double>(ring);
        text({1.5, y}, ring < rings ? std::to_string(ring + 1) : "out", case_ink::given);
        text({1.9, y}, ring < rings ? "25 %" : "0 %", case_ink::right);
        text({2.4, y}, fmt::format("{:.3g} %", found[ring]), case_ink::yours);
    }
    text({-1.3, -1.5}, words.right, case_ink::right);
    text({-1.3, -1.7}, words.yours, case_ink::yours);
    return drawing;
}

/// A density beside the right one, in words.
inline SpreadWords with_density(const std::string& title, double right, double yours) {
    return {
        title,
        std::isfinite(right) ? fmt::format("right: the density {:.4g}", right) : "right: a direction with its density",
        std::isfinite(yours) ? fmt::format("yours: {:.4g}, of the first point", yours) : "yours: no number"};
}

}  // namespace raylab::grading
