#include "raylab/report/chart/palette.h"

#include <fmt/format.h>

#include <array>

namespace raylab {

namespace {

// Okabe and Ito's colours, with a grey instead of yellow, which is too pale on white. Black is for `yours`.
constexpr std::array colors = {"#0072b2", "#e69f00", "#009e73", "#d55e00", "#56b4e9", "#cc79a7", "#6b6b6b"};

// The pentagon is for `yours`.
using enum MarkerStyle::Shape;
constexpr std::array shapes = {circle, square, triangle, diamond, triangle_down};

}  // namespace

MarkerStyle style_of(std::size_t index) { return {colors[index % colors.size()], shapes[index % shapes.size()]}; }

MarkerStyle style_of_yours() { return {"#000000", pentagon}; }

std::string tint_of(const std::string& color) {
    std::string text = "#";
    for (const std::size_t at : {1u, 3u, 5u}) {
        const int channel = std::stoi(color.substr(at, 2), nullptr, 16);
        text += fmt::format("{:02x}", 255 - (255 - channel) / 4);
    }
    return text;
}

}  // namespace raylab
