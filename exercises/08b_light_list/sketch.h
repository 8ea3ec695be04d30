#pragma once

#include "flat_view.h"
#include "symptoms.h"

#include <fmt/format.h>

namespace raylab::grading::light_list {

// The drawing has depth from left to right, scaled to this width.
inline constexpr double sketch_width = 12;

/// The way from the light to the point, and where the list's entries begin; over them the tests that had to be made,
/// and an answer's, in its order.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    double deepest = given.depth;
    for (const Entry& entry : given.entries) deepest = std::max(deepest, entry.begin);
    const auto across = [&](double depth) { return sketch_width * depth / deepest; };
    PlaneDrawing drawing{.title = "depth to the right, from the light to the point and beyond; lines: entries begin",
                         .low = {-2.4, -3.2},
                         .high = {13.6, 2.6},
                         .notes = {"green: tests that have to be made, and the share; red: yours, in your order"}};
    const auto mark = [&](PlaneDrawing::Mark added) { drawing.marks.push_back(std::move(added)); };
    const auto text = [&](PlanePoint at, const std::string& words, const char* color) {
        mark(PlaneDrawing::Text{.at = at, .words = words, .color = color, .anchor = Anchor::center, .halo = "#ffffff"});
    };
    if (given.filled < deepest)
        mark(PlaneDrawing::Figure{.shape = PlanePolygon{{{across(given.filled), -0.6},
                                                         {sketch_width + 1, -0.6},
                                                         {sketch_width + 1, 0.6},
                                                         {across(given.filled), 0.6}}},
                                  .style = {.line = case_ink::faint, .fill = "#e0e0e0", .width = 1}});
    mark(PlaneDrawing::Arrow{{across(given.depth), 0}, {0, 0}, {.line = case_ink::given, .width = 2}});
    mark(PlaneDrawing::Dot{{0, 0}, 6, "#e69f00"});
    text({0, -1}, "light", case_ink::given);
    mark(PlaneDrawing::Dot{{across(given.depth), 0}, 5, case_ink::given});
    text({across(given.depth), -1}, "point", case_ink::given);
    bool is_dark = is_behind_what_fills(given);
    for (int i = 0; i < given.count(); ++i) {
        const auto [begin, share] = *given.entry(i);
        const bool needed = !is_dark && begin <= given.depth;
        is_dark = is_dark || share == 0;
        mark(PlaneDrawing::Path{{{across(begin), -0.6}, {across(begin), 0.6}},
                                {.line = needed ? case_ink::right : case_ink::faint, .width = needed ? 4.0 : 2.0}});
        text({across(begin), 0.8 + 0.45 * (i % 2)}, fmt::format("{}: {:.3g}", i, share),
             needed ? case_ink::right : case_ink::faint);
    }
    std::string order;
    for (const int i : asked_of(answer)) order += i == no_entry ? " ?" : fmt::format(" {}", i);
    text({sketch_width / 2, 2.2}, "each entry: its number, and what it lets through", case_ink::given);
    text({sketch_width / 2, -1.9}, fmt::format("right: {:.6g}", truth(given)), case_ink::right);
    text({sketch_width / 2, -2.7},
         fmt::format("yours: {}, by tests of{}",
                     std::isfinite(answer[0]) ? fmt::format("{:.6g}", answer[0]) : "no number",
                     order.empty() ? " nothing" : order),
         case_ink::yours);
    return drawing;
}

}  // namespace raylab::grading::light_list
