#pragma once

#include "arguments.h"
#include "dots.h"
#include "exercise.h"

#include <numbers>

namespace raylab::grading::heuristic {

// Above: the densities of two strategies over directions from left to right; the light's is high in the middle of it
// and zero beyond its edge, the lobe's is wide. Below: the weights of both, and their sum, which has to be the dotted
// line.
inline constexpr int picture_width = 480, picture_height = 300;
inline constexpr double left_edge = 12, right_edge = 468;  // pixels
inline constexpr std::size_t columns = 229;                // directions, two pixels apart

inline double direction_of(std::size_t i) { return 2 * static_cast<double>(i) / (columns - 1) - 1; }

/// Chosen by the light, which is seen from -0.45 to 0.15: higher where it is nearer.
inline double light_density(double direction) {
    const double from_middle = (direction + 0.15) / 0.3;
    return std::abs(from_middle) < 1 ? (1 - 0.36 * from_middle) / 0.6 : 0;
}

/// Chosen by a glossy lobe around 0.25.
inline double lobe_density(double direction) {
    const double from_middle = (direction - 0.25) / 0.35;
    return std::exp(-from_middle * from_middle) / (0.35 * std::sqrt(std::numbers::pi));
}

/// Both weights of each direction. Where the light is not seen its strategy chooses nothing, and its answer is not
/// drawn.
inline std::vector<Case> weighted_directions() {
    std::vector<Case> all;
    for (std::size_t i = 0; i < columns; ++i) {
        const double light = light_density(direction_of(i)), lobe = lobe_density(direction_of(i));
        all.push_back({"", Case::Kind::graded, {light > 0 ? light : lobe, lobe}});
        all.push_back({"", Case::Kind::graded, {lobe, light}});
    }
    return all;
}

/// A curve through values of the directions, as high as `unit` pixels for 1; gaps where a value is not finite.
template <class Value>
void draw_curve(Image& image, double base, double unit, const Pixel& color, const Value& value) {
    constexpr double highest = 1.5;  // more than that leaves the picture
    const auto at = [&](std::size_t i) {
        return Point2{left_edge + (right_edge - left_edge) * static_cast<double>(i) / (columns - 1),
                      base - unit * value(i)};
    };
    for (std::size_t i = 1; i < columns; ++i)
        if (std::abs(value(i - 1)) < highest * 2 && std::abs(value(i)) < highest * 2)
            draw_line(image, at(i - 1), at(i), 2, color);
}

inline Image draw_weights(std::span<const double> weights) {
    Image image(picture_width, picture_height, paper);
    constexpr double densities_base = 120, densities_unit = 48, base = 286, unit = 105;  // pixels
    const auto light = [](std::size_t i) { return light_density(direction_of(i)); };
    const auto lobe = [](std::size_t i) { return lobe_density(direction_of(i)); };
    const auto by_light = [&](std::size_t i) { return light(i) > 0 ? weights[2 * i] : 0; };
    const auto by_lobe = [&](std::size_t i) { return weights[2 * i + 1]; };
    draw_line(image, {left_edge, densities_base}, {right_edge, densities_base}, 1, ink::black);
    draw_line(image, {left_edge, base}, {right_edge, base}, 1, ink::black);
    for (double x = left_edge; x <= right_edge; x += 8) draw_disk(image, {x, base - unit}, 1.4, ink::black);
    draw_curve(image, densities_base, densities_unit, ink::vermilion, light);
    draw_curve(image, densities_base, densities_unit, ink::blue, lobe);
    draw_curve(image, base, unit, ink::grey, [&](std::size_t i) { return by_light(i) + by_lobe(i); });
    draw_curve(image, base, unit, ink::vermilion, by_light);
    draw_curve(image, base, unit, ink::blue, by_lobe);
    return image;
}

inline Picture heuristic_picture() {
    return {.about =
                "above, the densities of choosing by the light (red) and by the lobe (blue); below, your weights of "
                "both, and their sum (grey), which has to be the dotted 1",
            .width = picture_width,
            .height = picture_height,
            .all_cases = weighted_directions,
            .draw = draw_weights};
}

}  // namespace raylab::grading::heuristic
