#pragma once

#include "raylab/report/chart/label_layout.h"
#include "raylab/report/chart/palette.h"
#include "raylab/report/plane/plane_drawing.h"

#include <string>
#include <utility>
#include <vector>

// A chart as a drawing in pixels: x to the right, y down from the upper left corner.

namespace raylab {

struct SketchText {
    double size = 13;  // of the font; nothing is smaller, so that a whole chart fits a lecture's slide
    enum class Weight { regular, bold } weight = Weight::regular;
    Anchor anchor = Anchor::left;
    std::string color = text_color;
    enum class Ground { none, paper } ground = Ground::none;  // paper: a white rim hides what lies below the letters
};

/// What a mark says of itself where a pointer is over it, and to the page's script.
struct MarkWords {
    std::string tooltip;
    std::vector<std::pair<std::string, std::string>> data;  // "method", "watertight": written as data-method
};

enum class MarkFill { filled, hollow };

class Sketch {
public:
    Sketch(double width, double height);

    /// Words whose middle line is at y.
    void text(double x, double y, const std::string& words, const SketchText& style = {});
    void line(double x0, double y0, double x1, double y1, const PlaneStyle& style);
    void path(const std::vector<Point2>& points, const PlaneStyle& style);
    void rectangle(const Rectangle& area, const PlaneStyle& style, const MarkWords& words = {});
    void area(const std::vector<Point2>& convex, const PlaneStyle& style);
    /// A method's or a workload's mark, about 2 * `reach` pixels across.
    void marker(double x, double y, double reach, const MarkerStyle& look, MarkFill fill = MarkFill::filled,
                const MarkWords& words = {});

    PlaneDrawing drawing() &&;

private:
    PlanePoint at(double x, double y) const;

    double height_;
    PlaneDrawing drawing_;
};

/// The words of a text in lines that are at most `width` pixels wide.
std::vector<std::string> lines_in(const std::string& text, double width, const SketchText& style);

}  // namespace raylab
