#pragma once

#include "cells.h"
#include "dots.h"
#include "exercise.h"

namespace raylab::grading::jitter {

// Pixels with 16, 7 and 30 samples each: of every cell its outline, and some points in the colour of their u.
inline constexpr int picture_width = 630, picture_height = 220;
inline constexpr std::array<int, 3> picture_counts{16, 7, 30};
inline constexpr double picture_seed = 15;  // of squares

inline Image draw_jitter(std::span<const double> answers) {
    Image image(picture_width, picture_height, paper);
    constexpr double side = 190, base = 205;  // pixels
    const auto numbers = number_pairs(picture_seed);
    for (std::size_t k = 0; k < picture_counts.size(); ++k) {
        const auto answer = answers.subspan(k * outputs, outputs);
        const auto at = [&](double x, double y) {
            const auto near = [](double value) {
                return std::isfinite(value) ? std::clamp(value, -0.06, 1.06) : -0.06;
            };
            return Point2{15 + 205 * static_cast<double>(k) + side * near(x), base - side * near(y)};
        };
        const auto outline = [&](const CellBox& b, double width, const Pixel& color) {
            draw_line(image, at(b.left, b.low), at(b.right, b.low), width, color);
            draw_line(image, at(b.right, b.low), at(b.right, b.high), width, color);
            draw_line(image, at(b.right, b.high), at(b.left, b.high), width, color);
            draw_line(image, at(b.left, b.high), at(b.left, b.low), width, color);
        };
        for (std::size_t i = 0; i < pairs; i += 31) draw_dot(image, at(answer[2 * i], answer[2 * i + 1]), numbers[i]);
        for (const CellBox& cell : boxes_of(static_cast<std::size_t>(picture_counts[k]), answer))
            outline(cell, 1, ink::grey);
        outline({0, 1, 0, 1}, 2, ink::black);
    }
    return image;
}

inline Picture jitter_picture() {
    return {.about = "pixels with 16, 7 and 30 samples: the cells, and points in them, coloured by u",
            .width = picture_width,
            .height = picture_height,
            .all_cases =
                [] {
                    std::vector<Case> all;
                    for (const int count : picture_counts)
                        all.push_back({"", Case::Kind::graded, {double(count), picture_seed}});
                    return all;
                },
            .draw = draw_jitter};
}

}  // namespace raylab::grading::jitter
