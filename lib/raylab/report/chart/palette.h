#pragma once

#include <cstddef>
#include <string>

namespace raylab {

// What is not data.
constexpr const char* text_color = "#222222";
constexpr const char* quiet_color = "#5c5c66";
constexpr const char* axis_color = "#9a9aa2";
constexpr const char* grid_color = "#e6e6ea";

/// The look of a method or a workload in every chart: a colour that is hard to confuse (Okabe and Ito, 2008) and a
/// shape, because colour must never be the only distinction.
struct MarkerStyle {
    enum class Shape { circle, square, triangle, diamond, triangle_down, pentagon };
    std::string color;  // "#d55e00"
    Shape shape;
};

/// The look of the method with this index; 35 looks differ.
MarkerStyle style_of(std::size_t index);

/// A colour that is three quarters white: of an area behind a line of this colour.
std::string tint_of(const std::string& color);

/// The look of the reader's own method, `yours`, which no other method has.
MarkerStyle style_of_yours();

}  // namespace raylab
