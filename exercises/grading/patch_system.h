#pragma once

#include "dice.h"
#include "words.h"

#include "raylab/image/image.h"
#include "raylab/radiosity/radiosity_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Systems of a few patches as the doubles of a case.

namespace raylab::grading {

inline constexpr std::size_t most_patches = 6;
inline constexpr std::size_t color_doubles = 3 * most_patches;
// Their number, areas, emissions, reflectances and form factors, row by row; what is not there is 0.
inline constexpr std::size_t system_doubles = 1 + most_patches + 2 * color_doubles + most_patches * most_patches;

/// Takes what stands first off the input.
inline std::span<const double> taken(std::span<const double>& in, std::size_t count) {
    const auto first = in.first(count);
    in = in.subspan(count);
    return first;
}

/// One colour for each patch.
inline std::vector<Color> colors_of(std::span<const double> in, std::size_t patches) {
    std::vector<Color> colors;
    for (std::size_t i = 0; i < patches; ++i) colors.emplace_back(in[3 * i], in[3 * i + 1], in[3 * i + 2]);
    return colors;
}

inline RadiositySystem system_of(std::span<const double> in) {
    const auto patches = static_cast<std::size_t>(taken(in, 1)[0]);
    const auto area = taken(in, most_patches).first(patches);
    const auto emission = colors_of(taken(in, color_doubles), patches);
    const auto reflectance = colors_of(taken(in, color_doubles), patches);
    FormFactors form_factors(patches);
    for (std::size_t i = 0; i < patches; ++i)
        for (std::size_t j = 0; j < patches; ++j) form_factors.at(i, j) = in[most_patches * i + j];
    return {{area.begin(), area.end()}, emission, reflectance, std::move(form_factors)};
}

/// Writes the colours to the first doubles of the span.
inline void put_colors(std::span<const Color> colors, std::span<double> out) {
    for (std::size_t i = 0; i < colors.size(); ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
            out[3 * i + channel] = colors[i][static_cast<glm::length_t>(channel)];
}

/// The doubles of a case: the system, and then lists of one colour for each patch.
inline std::vector<double> as_input(const RadiositySystem& system, const std::vector<Radiosities>& lists) {
    std::vector<double> input(system_doubles + lists.size() * color_doubles);
    const std::span<double> in(input);
    input[0] = static_cast<double>(system.patches());
    for (std::size_t i = 0; i < system.patches(); ++i) input[1 + i] = system.area[i];
    std::size_t place = 1 + most_patches;
    for (const auto* colors : {&system.emission, &system.reflectance}) {
        put_colors(*colors, in.subspan(place));
        place += color_doubles;
    }
    for (std::size_t i = 0; i < system.patches(); ++i)
        for (std::size_t j = 0; j < system.patches(); ++j)
            input[place + most_patches * i + j] = system.form_factors.at(i, j);
    place = system_doubles;
    for (const Radiosities& colors : lists) {
        put_colors(colors, in.subspan(place));
        place += color_doubles;
    }
    return input;
}

/// Patches of different areas, colours and brightnesses, with reciprocity. Each row sums to less than 1; with `own`
/// above 0 each patch also sees itself, by half of that share at least.
inline RadiositySystem any_patches(Dice& dice, std::size_t patches, double own) {
    RadiositySystem system{.form_factors = FormFactors(patches)};
    for (std::size_t i = 0; i < patches; ++i) {
        system.area.push_back(dice.in(1, 4));
        system.emission.push_back(dice.point(0.2, 3));
        system.reflectance.push_back(dice.point(0.3, 0.9));
    }
    const double scale = 0.9 * (1 - own) / (4 * static_cast<double>(patches));
    for (std::size_t i = 0; i < patches; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double exchange = dice.in(0.5, 1) * scale;
            system.form_factors.at(i, j) = exchange * system.area[j];
            system.form_factors.at(j, i) = exchange * system.area[i];
        }
        system.form_factors.at(i, i) = own * dice.in(0.5, 1);
    }
    return system;
}

/// A unit cube from inside: left and right, floor and ceiling, back and front.
inline RadiositySystem cube_room() {
    constexpr double opposite = .199824895698387;
    constexpr double perpendicular = .200043776075403;
    const Color white(0.8);
    const Color black(0);
    RadiositySystem room{.area = std::vector<double>(6, 1.0),
                         .emission = {black, black, black, Color(1, 0.95, 0.8), black, black},
                         .reflectance = {Color(0.8, 0.15, 0.1), Color(0.15, 0.7, 0.2), white, white, white, white},
                         .form_factors = FormFactors(6)};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
            room.form_factors.at(i, j) = i == j ? 0 : i / 2 == j / 2 ? opposite : perpendicular;
    return room;
}

/// A pixel of the cube as an eye in its front wall sees it, each wall in its radiosity: `right` and `down` go from 0 to
/// 1 over the picture. A black frame separates it from others.
inline Pixel cube_room_pixel(double right, double down, const std::vector<Color>& radiosity) {
    constexpr double back = 0.45;  // half the side of the back wall, where that of the picture is 1
    const double x = 2 * right - 1;
    const double y = 1 - 2 * down;
    if (std::max(std::abs(x), std::abs(y)) > 0.97) return {};
    const std::size_t beside = std::abs(x) > std::abs(y) ? (x < 0 ? 0 : 1) : (y < 0 ? 2 : 3);
    const Color& seen = radiosity[std::max(std::abs(x), std::abs(y)) < back ? 4 : beside];
    const auto shown = [](double value) { return cast<float>(std::clamp(0.7 * value, 0.0, 1.0)); };
    return {shown(seen.r), shown(seen.g), shown(seen.b)};
}

/// The system as a verdict tells it, patch by patch.
inline std::string words(const RadiositySystem& system) {
    std::string text;
    for (std::size_t i = 0; i < system.patches(); ++i) {
        text += fmt::format(
            "patch {}  area {:.4g}, emission ({:.4g}, {:.4g}, {:.4g}), reflectance ({:.4g}, {:.4g}, {:.4g}), F", i,
            system.area[i], system.emission[i].r, system.emission[i].g, system.emission[i].b, system.reflectance[i].r,
            system.reflectance[i].g, system.reflectance[i].b);
        for (const double f : system.form_factors.row(i)) text += fmt::format(" {:.4g}", f);
        text += "\n";
    }
    return text;
}

inline std::string words(const std::vector<Color>& colors) {
    std::string text;
    for (const Color& color : colors)
        text += fmt::format("{}({:.10g}, {:.10g}, {:.10g})", text.empty() ? "" : " ", color.r, color.g, color.b);
    return text;
}

/// Whether each channel of each patch is within `tolerance` of the truth, relative to the largest value there.
inline bool is_close(std::span<const Color> got, std::span<const Color> truth, double tolerance) {
    double largest = 0;
    for (const Color& color : truth) largest = std::max({largest, color.r, color.g, color.b});
    for (std::size_t i = 0; i < truth.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
            if (!(std::abs(got[i][channel] - truth[i][channel]) <= tolerance * largest)) return false;
    return true;
}

}  // namespace raylab::grading
