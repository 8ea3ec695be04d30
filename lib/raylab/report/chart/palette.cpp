#include "raylab/report/chart/palette.h"

#include <array>

namespace raylab {

namespace {

// Okabe and Ito's colours, with a grey instead of yellow, which is too pale on white. Black is for `yours`.
constexpr std::array colors = {"#0072b2", "#e69f00", "#009e73", "#d55e00", "#56b4e9", "#cc79a7", "#6b6b6b"};

struct Shape {
    int filled, hollow;
};

// Circle, square, triangle, diamond, triangle upside down. The pentagon is for `yours`.
constexpr std::array<Shape, 5> shapes = {{{7, 6}, {5, 4}, {9, 8}, {13, 12}, {11, 10}}};

}  // namespace

MarkerStyle style_of(std::size_t index) {
    const auto& shape = shapes[index % shapes.size()];
    return {colors[index % colors.size()], shape.filled, shape.hollow};
}

MarkerStyle style_of_yours() { return {"#000000", 15, 14}; }

}  // namespace raylab
