#include "camera_drawings.h"

#include "raylab/report/plane/plane_angle.h"
#include "raylab/report/plane/plane_sketch.h"
#include "raylab/sampling/pixel_samples.h"

#include <array>
#include <string>

namespace raylab::ray_generation {

namespace {

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
    sketch.polygon({corner(0, 0), corner(columns, 0), corner(columns, rows), corner(0, rows)}, filled("#f4f8fb"));
    sketch.polygon({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}, filled("#fdd9b5"));
    for (int column = 0; column <= columns; ++column)
        sketch.line(corner(column, 0), corner(column, rows), stroke(light_grey, 1.2));
    for (int row = 0; row <= rows; ++row) sketch.line(corner(0, row), corner(columns, row), stroke(light_grey, 1.2));
    sketch.polygon({corner(0, 0), corner(columns, 0), corner(columns, rows), corner(0, rows)}, stroke(blue));
}

// From the picture's middle to its four edges.
void add_edges(PlaneSketch& sketch) {
    const PlaneStyle style{.line = blue, .width = 2};
    const auto edge = [&](double right, double up, const std::string& name, Point2 aside) {
        sketch.arrow(on_picture(0, 0), on_picture(right, up), style);
        sketch.words(on_picture(0.62 * right, 0.62 * up), name,
                     {.aside = aside, .anchor = Anchor::center, .color = blue, .height = 15});
    };
    edge(l, 0, "*l*", {4, -10});
    edge(r, 0, "*r*", {10, -8});
    edge(0, b, "*b*", {14, 8});
    edge(0, t, "*t*", {-12, 8});
}

void add_axis(PlaneSketch& sketch, PlanePoint tip, const std::string& name, const std::string& color, Point2 aside) {
    sketch.arrow(seen(0, 0, 0), tip, stroke(color));
    sketch.words(tip, name, {.aside = aside, .anchor = Anchor::center, .color = color, .height = 14, .halo = {}});
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
    const PlaneStyle thin = stroke(grey, 1.2, dashed);
    for (int column = 0; column <= few_columns; ++column) {
        const double x = points.first + column * points.pitch;
        sketch.line(at(x, first_row), at(x, bottom), thin);
    }
    for (int row = 0; row <= few_rows; ++row) {
        const double y = first_row + row * row_pitch;
        sketch.line(at(points.first, y), at(last, y), thin);
    }
    sketch.polygon({at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, stroke(blue, 3));
    for (int row = 0; row < few_rows; ++row)
        for (int column = 0; column < few_columns; ++column)
            sketch.dot(at(points.first + (column + 0.5) * points.pitch, first_row + (row + 0.5) * row_pitch), 6,
                       vermilion);
    const auto words = [&](double x, double y, const std::string& text, const std::string& color, double down) {
        sketch.words(at(x, y), text,
                     {.aside = {0, down}, .anchor = Anchor::center, .color = color, .height = 14, .halo = {}});
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
            sketch.line(at(edge, 0), at(edge, pixels), style);
            sketch.line(at(0, edge), at(pixels, edge), style);
        }
    };
    if (pattern.samples.pattern == SamplePattern::jittered)
        grid(pixels * pattern.samples.per_side, {.line = light_grey, .width = 1.2});
    grid(pixels, {.line = black, .width = 2.2});
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x)
            for (int sample = 0; sample < pattern.samples.count(); ++sample) {
                const PixelPoint p = pixel_sample(pattern.samples, static_cast<std::uint64_t>(pixels * y + x), sample);
                sketch.dot(at(x + p.x, y + p.y), pattern.samples.per_side == 1 ? 5.5 : 3.6, vermilion);
            }
    sketch.words(at(pixels / 2.0, pixels), pattern.name,
                 {.aside = {0, 30}, .anchor = Anchor::center, .height = 14, .halo = {}});
}

}  // namespace

PlaneDrawing draw_camera_numbers() {
    PlaneSketch sketch;
    const PlanePoint eye = seen(0, 0, 0);
    const double right = (column_edge(i) + column_edge(i + 1)) / 2, up = (row_edge(j) + row_edge(j + 1)) / 2;
    const PlanePoint point = on_picture(right, up);
    sketch.line(eye, on_picture(0, 0), stroke(black, 1.5, dashed));
    add_picture(sketch);
    for (const double x : {l, r})
        for (const double y : {b, t}) sketch.line(eye, on_picture(x, y), stroke(light_grey, 1.2));
    add_edges(sketch);
    sketch.add(right_angle(on_picture(0, 0), seen(d - 1, 0, 0), on_picture(0, 1), 0.28, {.line = black, .width = 1.2}));
    sketch.arrow(eye, seen(1.9 * d, 1.9 * right, 1.9 * up), stroke(vermilion));
    sketch.dot(point, 6, vermilion);
    sketch.words(point, "*P*_{ij}", {.aside = {4, 30}, .color = vermilion, .height = 15});
    sketch.words(seen(1.75 * d, 1.75 * right, 1.75 * up), "the ray *C* + *t* **v**",
                 {.aside = {-70, -6}, .anchor = Anchor::center, .color = vermilion, .height = 14, .halo = {}});
    add_axis(sketch, seen(1.6, 0, 0), "**f**", green, {-6, 24});
    add_axis(sketch, seen(0, 1.6, 0), "**r**", green, {14, 12});
    add_axis(sketch, seen(0, 0, 1.6), "**u**", green, {-16, 8});
    sketch.dot(eye, 7, black);
    sketch.words(eye, "*C*", {.aside = {-30, 8}, .color = black, .height = 16, .halo = {}});
    sketch.words(seen(0.62 * d, 0, 0), "*d*", {.aside = {0, 24}, .color = black, .height = 16, .halo = {}});
    sketch.words(on_picture((column_edge(i) + column_edge(i + 1)) / 2, t), "column *i*",
                 {.aside = {-4, -12}, .anchor = Anchor::left, .color = black, .height = 13, .halo = {}});
    sketch.words(on_picture(r, up), "row *j*", {.aside = {10, 8}, .color = black, .height = 13, .halo = {}});
    return sketch.drawing({-0.9, -3.0}, {8.9, 3.2}, 960, 600);
}

PlaneDrawing draw_pixel_points() {
    PlaneSketch sketch;
    add_points(sketch, {"pixels fill the picture", "*l* + (*r* – *l*) (*i* + 1/2) / *w*", 0, 0, 1.0 / few_columns}, 0,
               1.0 / few_rows);
    constexpr double wide = 1.0 / (few_columns - 1), high = 1.0 / (few_rows - 1);
    add_points(sketch, {"points from edge to edge", "*l* + (*r* – *l*) *i* / (*w* – 1)", 8.8, -wide / 2, wide},
               -high / 2, high);
    return sketch.drawing({-0.7, -1.3}, {16.0, 5.2}, 960, 430);
}

PlaneDrawing draw_sample_patterns(std::uint64_t seed) {
    const std::array<Pattern, 4> patterns{{{"centre", {SamplePattern::center, 1}},
                                           {"corner", {SamplePattern::corner, 1}},
                                           {"9 jittered", {SamplePattern::jittered, 3, seed}},
                                           {"9 random", {SamplePattern::random, 3, seed}}}};
    constexpr double apart = pixels + 0.6;
    PlaneSketch sketch;
    for (std::size_t k = 0; k < patterns.size(); ++k) add_pattern(sketch, patterns[k], apart * static_cast<double>(k));
    return sketch.drawing({0, -0.3}, {4 * apart - 0.6, pixels}, 960, 270);
}

}  // namespace raylab::ray_generation
