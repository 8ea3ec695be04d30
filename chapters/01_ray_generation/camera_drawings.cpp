#include "camera_drawings.h"

#include "raylab/report/plane/plane_angle.h"
#include "raylab/report/plane/plane_sketch.h"
#include "raylab/sampling/pixel_samples.h"

#include <array>
#include <string>

namespace raylab::ray_generation {

namespace {

using Arrow = PlaneDrawing::Arrow;
using Dash = PlaneStyle::Dash;
using Dot = PlaneDrawing::Dot;
using Figure = PlaneDrawing::Figure;
using Path = PlaneDrawing::Path;
using Text = PlaneDrawing::Text;

using namespace plane_ink;

// Space in an oblique view from behind the camera's right shoulder; lengths along forward and up are true.
PlanePoint seen(double forward, double right, double up) { return {forward + 0.62 * right, up - 0.42 * right}; }

// The picture of the sketch, in the camera's own lengths.
constexpr double d = 5, l = -2.4, r = 2.4, b = -1.8, t = 1.8;
constexpr int columns = 8, rows = 6, i = 1, j = 1;

PlanePoint on_picture(double right, double up) { return seen(d, right, up); }
double column_edge(int column) { return l + (r - l) * column / columns; }
double row_edge(int row) { return t - (t - b) * row / rows; }

void add_picture(PlaneSketch& sketch) {
    const auto corner = [](int column, int row) { return on_picture(column_edge(column), row_edge(row)); };
    sketch.add(Figure{PlanePolygon{{corner(0, 0), corner(columns, 0), corner(columns, rows), corner(0, rows)}},
                      {.line = "", .fill = "#f4f8fb"}});
    sketch.add(Figure{PlanePolygon{{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}},
                      {.line = "", .fill = "#fdd9b5"}});
    for (int column = 0; column <= columns; ++column)
        sketch.add(Path{{corner(column, 0), corner(column, rows)}, {.line = light_grey, .width = 1.2}});
    for (int row = 0; row <= rows; ++row)
        sketch.add(Path{{corner(0, row), corner(columns, row)}, {.line = light_grey, .width = 1.2}});
    sketch.add(Figure{PlanePolygon{{corner(0, 0), corner(columns, 0), corner(columns, rows), corner(0, rows)}},
                      {.line = blue, .width = 2.5}});
}

// From the picture's middle to its four edges.
void add_edges(PlaneSketch& sketch) {
    const PlaneStyle style{.line = blue, .width = 2};
    const auto edge = [&](double right, double up, const std::string& name, Point2 aside) {
        sketch.add(Arrow{on_picture(0, 0), on_picture(right, up), style});
        sketch.add(Text{.at = on_picture(0.62 * right, 0.62 * up),
                        .words = name,
                        .height = 15,
                        .color = blue,
                        .anchor = Anchor::center,
                        .aside = aside,
                        .halo = "#ffffff"});
    };
    edge(l, 0, "*l*", {4, -10});
    edge(r, 0, "*r*", {10, -8});
    edge(0, b, "*b*", {14, 8});
    edge(0, t, "*t*", {-12, 8});
}

void add_axis(PlaneSketch& sketch, PlanePoint tip, const std::string& name, const std::string& color, Point2 aside) {
    sketch.add(Arrow{seen(0, 0, 0), tip, {.line = color, .width = 2.5}});
    sketch.add(Text{.at = tip, .words = name, .height = 14, .color = color, .anchor = Anchor::center, .aside = aside});
}

// A grid of pixels, and a point in each.
struct Points {
    std::string title, formula;
    double left;          // of the panel, in the drawing
    double first, pitch;  // where the first column begins and how wide one is, as shares of the picture's width
};

constexpr int few_columns = 6, few_rows = 4;

void add_points(PlaneSketch& sketch, const Points& points, double first_row, double row_pitch) {
    const auto at = [&](double x, double y) { return PlanePoint{points.left + few_columns * x, few_rows * (1 - y)}; };
    const double last = points.first + few_columns * points.pitch, bottom = first_row + few_rows * row_pitch;
    const PlaneStyle dashed{.line = grey, .width = 1.2, .dash = Dash::dashed};
    for (int column = 0; column <= few_columns; ++column) {
        const double x = points.first + column * points.pitch;
        sketch.add(Path{{at(x, first_row), at(x, bottom)}, dashed});
    }
    for (int row = 0; row <= few_rows; ++row) {
        const double y = first_row + row * row_pitch;
        sketch.add(Path{{at(points.first, y), at(last, y)}, dashed});
    }
    sketch.add(Figure{PlanePolygon{{at(0, 0), at(1, 0), at(1, 1), at(0, 1)}}, {.line = blue, .width = 3}});
    for (int row = 0; row < few_rows; ++row)
        for (int column = 0; column < few_columns; ++column)
            sketch.add(Dot{at(points.first + (column + 0.5) * points.pitch, first_row + (row + 0.5) * row_pitch), 6,
                           vermilion});
    const auto words = [&](double x, double y, const std::string& text, const std::string& color, double down) {
        sketch.add(Text{
            .at = at(x, y), .words = text, .height = 14, .color = color, .anchor = Anchor::center, .aside = {0, down}});
    };
    words(0.5, 0, points.title, black, -52);
    words(0.5, 1, points.formula, black, 68);
    words(0, 1, "*l*", blue, 68);
    words(1, 1, "*r*", blue, 68);
}

struct Pattern {
    std::string name;
    PixelSamples samples;
};

constexpr int pixels = 3;  // a side

void add_pattern(PlaneSketch& sketch, const Pattern& pattern, double left) {
    const auto at = [&](double x, double y) { return PlanePoint{left + x, pixels - y}; };
    const auto grid = [&](int lines, const PlaneStyle& style) {
        for (int line = 0; line <= lines; ++line) {
            const double edge = 1.0 * pixels * line / lines;
            sketch.add(Path{{at(edge, 0), at(edge, pixels)}, style});
            sketch.add(Path{{at(0, edge), at(pixels, edge)}, style});
        }
    };
    if (pattern.samples.pattern == SamplePattern::jittered)
        grid(pixels * pattern.samples.per_side, {.line = light_grey, .width = 1.2});
    grid(pixels, {.line = black, .width = 2.2});
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x)
            for (int sample = 0; sample < pattern.samples.count(); ++sample) {
                const PixelPoint p = pixel_sample(pattern.samples, static_cast<std::uint64_t>(pixels * y + x), sample);
                sketch.add(Dot{at(x + p.x, y + p.y), pattern.samples.per_side == 1 ? 5.5 : 3.6, vermilion});
            }
    sketch.add(Text{.at = at(pixels / 2.0, pixels),
                    .words = pattern.name,
                    .height = 14,
                    .anchor = Anchor::center,
                    .aside = {0, 30}});
}

}  // namespace

PlaneDrawing draw_camera_numbers() {
    PlaneSketch sketch;
    const PlanePoint eye = seen(0, 0, 0);
    const double right = (column_edge(i) + column_edge(i + 1)) / 2, up = (row_edge(j) + row_edge(j + 1)) / 2;
    const PlanePoint point = on_picture(right, up);
    sketch.add(Path{{eye, on_picture(0, 0)}, {.line = black, .width = 1.5, .dash = Dash::dashed}});
    add_picture(sketch);
    for (const double x : {l, r})
        for (const double y : {b, t}) sketch.add(Path{{eye, on_picture(x, y)}, {.line = light_grey, .width = 1.2}});
    add_edges(sketch);
    sketch.add(right_angle(on_picture(0, 0), seen(d - 1, 0, 0), on_picture(0, 1), 0.28, {.line = black, .width = 1.2}));
    sketch.add(Arrow{eye, seen(1.9 * d, 1.9 * right, 1.9 * up), {.line = vermilion, .width = 2.5}});
    sketch.add(Dot{point, 6, vermilion});
    sketch.add(
        Text{.at = point, .words = "*P*_{ij}", .height = 15, .color = vermilion, .aside = {4, 30}, .halo = "#ffffff"});
    sketch.add(Text{.at = seen(1.75 * d, 1.75 * right, 1.75 * up),
                    .words = "the ray *C* + *t* **v**",
                    .height = 14,
                    .color = vermilion,
                    .anchor = Anchor::center,
                    .aside = {-70, -6}});
    add_axis(sketch, seen(1.6, 0, 0), "**f**", green, {-6, 24});
    add_axis(sketch, seen(0, 1.6, 0), "**r**", green, {14, 12});
    add_axis(sketch, seen(0, 0, 1.6), "**u**", green, {-16, 8});
    sketch.add(Dot{eye, 7, black});
    sketch.add(Text{.at = eye, .words = "*C*", .height = 16, .color = black, .aside = {-30, 8}});
    sketch.add(Text{.at = seen(0.62 * d, 0, 0), .words = "*d*", .height = 16, .color = black, .aside = {0, 24}});
    sketch.add(Text{.at = on_picture((column_edge(i) + column_edge(i + 1)) / 2, t),
                    .words = "column *i*",
                    .height = 13,
                    .color = black,
                    .anchor = Anchor::left,
                    .aside = {-4, -12}});
    sketch.add(Text{.at = on_picture(r, up), .words = "row *j*", .height = 13, .color = black, .aside = {10, 8}});
    return {.low = {-0.9, -3.0}, .high = {8.9, 3.2}, .width = 960, .height = 600, .marks = sketch.marks()};
}

PlaneDrawing draw_pixel_points() {
    PlaneSketch sketch;
    add_points(sketch, {"pixels fill the picture", "*l* + (*r* – *l*) (*i* + 1/2) / *w*", 0, 0, 1.0 / few_columns}, 0,
               1.0 / few_rows);
    constexpr double wide = 1.0 / (few_columns - 1), high = 1.0 / (few_rows - 1);
    add_points(sketch, {"points from edge to edge", "*l* + (*r* – *l*) *i* / (*w* – 1)", 8.8, -wide / 2, wide},
               -high / 2, high);
    return {.low = {-0.7, -1.3}, .high = {16.0, 5.2}, .width = 960, .height = 430, .marks = sketch.marks()};
}

PlaneDrawing draw_sample_patterns(std::uint64_t seed) {
    const std::array<Pattern, 4> patterns{{{"centre", {SamplePattern::center, 1}},
                                           {"corner", {SamplePattern::corner, 1}},
                                           {"9 jittered", {SamplePattern::jittered, 3, seed}},
                                           {"9 random", {SamplePattern::random, 3, seed}}}};
    constexpr double apart = pixels + 0.6;
    PlaneSketch sketch;
    for (std::size_t k = 0; k < patterns.size(); ++k) add_pattern(sketch, patterns[k], apart * static_cast<double>(k));
    return {.low = {0, -0.3}, .high = {4 * apart - 0.6, pixels}, .width = 960, .height = 270, .marks = sketch.marks()};
}

}  // namespace raylab::ray_generation
