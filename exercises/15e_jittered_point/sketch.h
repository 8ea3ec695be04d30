#pragma once

#include "cells.h"
#include "flat_view.h"
#include "symptom.h"

namespace raylab::grading::jitter {

/// The square, and an answer's cells with some of their points.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const std::size_t count = count_of(question.input);
    PlaneDrawing drawing{.title = "the unit square, and the cells that your points tell of",
                         .low = {-0.5, -0.12},
                         .high = {1.5, 1.12},
                         .notes = {"red: yours, by their corners, with the points of some pairs of numbers"}};
    const auto mark = [&](PlaneDrawing::Mark added) { drawing.marks.push_back(std::move(added)); };
    const auto near = [](double x) { return std::isfinite(x) ? std::clamp(x, -0.5, 1.5) : -0.5; };
    const auto box = [&](const CellBox& b, const PlaneStyle& style) {
        mark(PlaneDrawing::Figure{.shape = PlanePolygon{{{near(b.left), near(b.low)},
                                                         {near(b.right), near(b.low)},
                                                         {near(b.right), near(b.high)},
                                                         {near(b.left), near(b.high)}}},
                                  .style = style});
    };
    box({0, 1, 0, 1}, {.line = case_ink::right, .width = 4});
    for (const CellBox& cell : boxes_of(count, answer)) box(cell, {.line = case_ink::yours, .width = 1.5});
    for (std::size_t i = 0; i < pairs; i += 97)
        mark(PlaneDrawing::Dot{{near(answer[2 * i]), near(answer[2 * i + 1])}, 2, case_ink::yours});
    mark(PlaneDrawing::Text{.at = {0, -0.08},
                            .words = fmt::format("right: {} cells of area 1/{} that fill the square", count, count),
                            .color = case_ink::right});
    mark(PlaneDrawing::Text{.at = {0, 1.04}, .words = "yours", .color = case_ink::yours});
    return drawing;
}

}  // namespace raylab::grading::jitter
