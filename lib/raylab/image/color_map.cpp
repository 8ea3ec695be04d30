#include "raylab/image/color_map.h"

#include "raylab/image/color.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <numbers>

namespace raylab {

namespace {

double inverse_lab_curve(double f) {  // CIE 15
    constexpr double delta = 6.0 / 29;
    return f > delta ? f * f * f : 3 * delta * delta * (f - 4.0 / 29);
}

glm::dvec3 rgb_from_lab(double lightness, double a, double b) {
    const double f = (lightness + 16) / 116;
    const glm::dvec3 d65(0.9505, 1.0, 1.0890);
    const glm::dvec3 xyz =
        d65 * glm::dvec3(inverse_lab_curve(f + a / 500), inverse_lab_curve(f), inverse_lab_curve(f - b / 200));
    // IEC 61966-2-1, equation (7); glm takes columns.
    const glm::dmat3 rgb_from_xyz(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570);
    return rgb_from_xyz * xyz;
}

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
        return rgb_from_lab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
    };
    // As colourful as a screen can show at this lightness, which carries the number and therefore stays.
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
