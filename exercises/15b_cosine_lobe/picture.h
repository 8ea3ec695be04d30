#pragma once

#include "arguments.h"
#include "dots.h"
#include "exercise.h"

#include <numbers>

namespace raylab::grading::cosine_lobe {

// Left: the hemisphere over a surface, seen from a little above, with one dot for 16 directions. Right: for each of
// nine bands of ten degrees from straight above (left) to the horizon (right), a bar for how many directions a
// steradian it has, and a line for the density that the function says of them. Both are a cosine, as the dotted curve.
inline constexpr int picture_width = 480, picture_height = 260;
inline constexpr double picture_seed = 18;  // of squares
inline constexpr std::size_t bands = 9;

struct Band {
    double directions = 0;  // how many
    double steradians = 0;  // the sum of 1 / density: each direction stands for as much
};

inline std::array<Band, bands> bands_of(std::span<const double> answer) {
    std::array<Band, bands> all{};
    for (std::size_t i = 0; i < pairs; ++i) {
        const auto [direction, pdf] = sampled(answer, i);
        const double length = glm::length(direction);
        if (!(length > 0) || !std::isfinite(length) || !(direction.z >= 0)) continue;
        const double quarters = std::acos(std::min(1.0, direction.z / length)) * 2 / std::numbers::pi;
        Band& band = all[std::min(bands - 1, static_cast<std::size_t>(quarters * bands))];
        band.directions += 1;
        band.steradians += pdf > 0 ? 1 / pdf : 0;
    }
    return all;
}

inline Image draw_lobe(std::span<const double> answer) {
    Image image(picture_width, picture_height, paper);
    constexpr Point2 center{130, 190};
    constexpr double scale = 112, lean = 0.3;  // pixels; the sine of the angle from which the eye looks down
    const double upright = std::sqrt(1 - lean * lean);
    const auto seen = [&](const Vec3d& d) {
        return Point2{center.x + scale * d.x, center.y - scale * (upright * d.z + lean * d.y)};
    };
    const auto arc = [&](double from, double to, const auto& direction) {
        constexpr int steps = 60;
        for (int i = 0; i < steps; ++i)
            draw_line(image, seen(direction(from + (to - from) * i / steps)),
                      seen(direction(from + (to - from) * (i + 1) / steps)), 1.2, ink::grey);
    };
    const double turn = 2 * std::numbers::pi;
    arc(0, turn, [](double a) { return Vec3d{std::cos(a), std::sin(a), 0}; });
    // The outline is the great circle across the eye's direction, above the ground.
    arc(0, turn / 2, [&](double a) { return Vec3d{std::cos(a), lean * std::sin(a), upright * std::sin(a)}; });
    const auto numbers = number_pairs(picture_seed);
    for (const std::size_t i : drawn_pairs()) draw_dot(image, seen(sampled(answer, i).direction), numbers[i]);
    draw_arrow(image, center, seen({0, 0, 1.25}), 1.8, ink::black);

    constexpr double left = 280, base = 236, width = 20, high = 190;  // pixels; `high` is the density 1 / pi
    const auto top = [&](double density) { return base - high * std::clamp(density * std::numbers::pi, 0.0, 1.2); };
    const auto all = bands_of(answer);
    for (std::size_t i = 0; i < bands; ++i) {
        const auto ends = [&](std::size_t k) {
            return std::cos(std::numbers::pi / 2 * static_cast<double>(k) / bands);
        };
        const double steradians = turn * (ends(i) - ends(i + 1)), x = left + width * static_cast<double>(i);
        const double share = all[i].directions / static_cast<double>(pairs);
        fill_bar(image, {x + 1, base}, {x + width - 1, top(share / steradians)}, ink::sky_blue);
        if (all[i].steradians == 0) continue;
        const double said = top(all[i].directions / all[i].steradians);
        draw_line(image, {x + 1, said}, {x + width - 1, said}, 3, ink::vermilion);
    }
    for (int degrees = 0; degrees <= 90; degrees += 3)
        draw_disk(image,
                  {left + width * bands * degrees / 90.0, top(std::cos(degrees * turn / 360) / std::numbers::pi)}, 1.2,
                  ink::black);
    draw_line(image, {left, base}, {left + width * bands, base}, 1.5, ink::black);
    return image;
}

inline Picture lobe_picture() {
    return {.about = "directions, coloured by u; beside them, from straight above to the horizon, how many there are a "
                     "steradian (bars) and which density you say (lines)",
            .width = picture_width,
            .height = picture_height,
            .all_cases =
                [] {
                    return std::vector<Case>{{"", Case::Kind::graded, {picture_seed}}};
                },
            .draw = draw_lobe};
}

}  // namespace raylab::grading::cosine_lobe
