#pragma once

#include "flat_view.h"
#include "symptoms.h"

#include <fmt/format.h>

namespace raylab::grading::branches {

/// What each branch can bring, level upon level, beside the least; and the weights, right and an answer's.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    constexpr double line = 2;  // the height of the least
    PlaneDrawing drawing{.title = "what a branch can still bring, level upon level; dashed: the least",
                         .low = {-2.6, -2.6},
                         .high = {6, 5.4},
                         .notes = {fmt::format("green: right; red: yours; {} levels left, rho = {:.4g}", given.levels,
                                               given.largest_share)}};
    const auto mark = [&](PlaneDrawing::Mark added) { drawing.marks.push_back(std::move(added)); };
    const auto text = [&](PlanePoint at, const std::string& words, const char* color) {
        mark(PlaneDrawing::Text{.at = at, .words = words, .color = color, .halo = "#ffffff"});
    };
    const auto weight = [](double value) {
        return std::isfinite(value) ? (value == 0 ? "not followed" : fmt::format("{:.4g}", value)) : "no number";
    };
    const auto right = truth(given);
    const auto branch = [&](double x, const std::string& name, double share, double of_right, double of_answer) {
        double height = 0;
        for (int level = 1; level <= std::min(given.levels, 40); ++level) {
            Arguments until = given;
            until.levels = level;
            const double top = given.least > 0 ? std::min(5.0, line * most(until, share) / given.least) : 5;
            if (top > height)
                mark(PlaneDrawing::Figure{
                    .shape = PlanePolygon{{{x, height}, {x + 0.9, height}, {x + 0.9, top}, {x, top}}},
                    .style = {.line = case_ink::given, .fill = "#e8e8e8", .width = 1}});
            height = top;
        }
        text({x, -0.5}, name, case_ink::given);
        text({x, -1.2}, weight(of_right), case_ink::right);
        text({x, -1.9}, weight(of_answer), case_ink::yours);
    };
    branch(0, "reflected", given.reflected, right.reflected, answer[0]);
    branch(3, "transmitted", given.transmitted, right.transmitted, answer[1]);
    mark(PlaneDrawing::Path{{{-0.5, line}, {5.5, line}},
                            {.line = case_ink::given, .width = 2, .dash = PlaneStyle::Dash::dashed}});
    text({-2.5, line}, fmt::format("{:.4g}", given.least), case_ink::given);
    text({-2.5, -1.2}, "right", case_ink::right);
    text({-2.5, -1.9}, "yours", case_ink::yours);
    return drawing;
}

}  // namespace raylab::grading::branches
