#pragma once

#include "arguments.h"
#include "dots.h"
#include "exercise.h"

namespace raylab::grading::lens {

// Left: a lens of radius 1 with one dot for 16 pairs. Right: how many of all points lie in each of ten rings of equal
// area, from the centre outwards; the line is where a tenth of them ends.
inline constexpr int picture_width = 480, picture_height = 260;
inline constexpr double picture_seed = 15;  // of squares
inline constexpr std::size_t rings = 10;

inline Image draw_lens(std::span<const double> answer) {
    Image image(picture_width, picture_height, paper);
    constexpr Point2 center{130, 130};
    constexpr double scale = 112;  // pixels a metre
    const auto numbers = number_pairs(picture_seed);
    for (const std::size_t i : drawn_pairs())
        draw_dot(image, {center.x + scale * answer[2 * i], center.y - scale * answer[2 * i + 1]}, numbers[i]);
    draw_circle(image, center, scale, 1.5, ink::black);
    draw_cross(image, center, 6, 1.5, ink::black);

    std::array<double, rings> counts{};
    for (std::size_t i = 0; i < pairs; ++i) {
        const double inside = answer[2 * i] * answer[2 * i] + answer[2 * i + 1] * answer[2 * i + 1];
        if (inside <= 1 + 1e-9) counts[static_cast<std::size_t>(std::min(inside, 0.999) * rings)] += 1;
    }
    constexpr double left = 280, base = 236, width = 18, tenth = 100;  // pixels
    for (std::size_t ring = 0; ring < rings; ++ring) {
        const double share = counts[ring] / static_cast<double>(pairs), x = left + width * static_cast<double>(ring);
        fill_bar(image, {x + 1, base}, {x + width - 1, base - std::min(2.2, rings * share) * tenth}, ink::sky_blue);
    }
    draw_line(image, {left, base}, {left + width * rings, base}, 1.5, ink::black);
    draw_line(image, {left - 6, base - tenth}, {left + width * rings + 6, base - tenth}, 2, ink::vermilion);
    return image;
}

inline Picture lens_picture() {
    return {.about = "points of the lens, coloured by u; beside it how many lie in each of ten rings of equal area",
            .width = picture_width,
            .height = picture_height,
            .all_cases =
                [] {
                    return std::vector<Case>{{"", Case::Kind::graded, {1, picture_seed}}};
                },
            .draw = draw_lens};
}

}  // namespace raylab::grading::lens
