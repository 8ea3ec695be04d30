#include "raylab/image/color_map.h"

#include "raylab/image/color.h"
#include "raylab/image/color_spaces.h"

#include <cmath>
#include <numbers>

namespace raylab {

namespace {

bool on_screen(const glm::dvec3& rgb) {
    for (int c = 0; c < 3; ++c)
        if (!(rgb[c] >= 0 && rgb[c] <= 1)) return false;
    return true;
}

}  // namespace

Pixel heat_color(double value) {
    const double t = unit_clamped(value);
    const double lightness = 97 * t;
    const double hue = (300 + 160 * t) * std::numbers::pi / 180;  // purple by way of red to yellow
    const auto color = [&](double chroma) {
        return rgb_from_lab({lightness, chroma * std::cos(hue), chroma * std::sin(hue)});
    };
    // The chroma is the largest that a screen can show at this lightness; the lightness stands for the number and is
    // kept.
    double shown = 0, wanted = 110 * std::pow(std::sin(std::numbers::pi * t), 0.7);
    for (int halving = 0; halving < 20; ++halving) {
        const double middle = (shown + wanted) / 2;
        (on_screen(color(middle)) ? shown : wanted) = middle;
    }
    const glm::dvec3 rgb = color(shown);
    return {static_cast<float>(unit_clamped(rgb.x)), static_cast<float>(unit_clamped(rgb.y)),
            static_cast<float>(unit_clamped(rgb.z))};
}

}  // namespace raylab
