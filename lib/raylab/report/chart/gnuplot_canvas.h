#pragma once

#include "raylab/report/chart/axis.h"
#include "raylab/report/chart/label_layout.h"
#include "raylab/report/chart/palette.h"

#include <string>

// Words, lines and markers at pixel positions of a gnuplot canvas, and the frame of a panel.

namespace raylab {

/// A canvas of pixels; y points up.
struct Canvas {
    double width, height;
};

struct TextStyle {
    double size = 14;
    enum class Weight { regular, bold } weight = Weight::regular;
    enum class Anchor { left, center, right } anchor = Anchor::left;
    std::string color = text_color;
    double turned = 0;                                        // rotation in degrees
    enum class Ground { none, paper } ground = Ground::none;  // paper: words hide what lies below them
};

std::string text_at(const Canvas& canvas, double x, double y, const std::string& text, const TextStyle& style = {});
std::string line_at(const Canvas& canvas, double x0, double y0, double x1, double y1, const std::string& color,
                    double width);
std::string marker_at(const Canvas& canvas, double x, double y, const MarkerStyle& look, double size);

/// Gnuplot's number of a filled marker.
int point_type(MarkerStyle::Shape shape);

enum class TickText { shown, hidden };

/// The frame of a panel at `area`: margins, axes, a faint grid, and tick texts where they are wanted.
std::string panel_at(const Canvas& canvas, const Rectangle& area, const AxisScale& x, TickText x_text,
                     const AxisScale& y, TickText y_text);

}  // namespace raylab
