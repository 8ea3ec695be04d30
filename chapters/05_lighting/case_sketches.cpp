#include "case_sketches.h"

#include <cmath>
#include <numbers>

namespace raylab::lighting {

namespace {

using namespace plane_ink;
using std::numbers::pi;

PlanePoint towards(double degrees, double length) {
    return {length * std::cos(degrees * pi / 180), length * std::sin(degrees * pi / 180)};
}

void add_direction(PlaneSketch& sketch, double degrees, const std::string& name, const std::string& color) {
    sketch.arrow({0, 0}, towards(degrees, 1.4), stroke(color));
    sketch.words(towards(degrees, 1.62), name, {.aside = {0, 6}, .anchor = Anchor::center, .color = color});
}

CaseSketch even_power() {
    PlaneSketch sketch = floor_with_point();
    add_direction(sketch, 140, "**L**", "#8a5a00");
    add_direction(sketch, 40, "**R**", blue);
    add_direction(sketch, 160, "**V**", vermilion);
    return case_sketch("V looks away from R: the cosine is negative, and squared it is a second highlight.", sketch,
                       {-2.1, -0.4}, {2.1, 1.8});
}

CaseSketch highlight_cut() {
    PlaneSketch sketch = floor_with_point();
    add_direction(sketch, 170, "**L**", "#8a5a00");
    add_direction(sketch, 10, "**R**", blue);
    add_direction(sketch, 26, "**V**", vermilion);
    return case_sketch("As the light sets, the cosine to V stays near 1: the highlight goes out all at once.", sketch,
                       {-2.1, -0.6}, {2.1, 1.4});
}

CaseSketch light_on_surface() {
    PlaneSketch sketch = floor_with_point();
    for (const double angle : {30.0, 60.0, 90.0, 120.0, 150.0})
        sketch.arrow({0, 0.08}, towards(angle, 1.1), stroke(orange, 1.8));
    sketch.light({0, 0.08});
    sketch.words({0, 0}, "*d* = 0", {.aside = {0, 28}, .anchor = Anchor::center});
    return case_sketch("The light stands on the floor: 1 / d² has no value there.", sketch, {-2.1, -0.7}, {2.1, 1.3});
}

CaseSketch spot_edge() {
    PlaneSketch sketch;
    sketch.polygon({{0, 2}, {-1.155, 0}, {1.155, 0}}, {.line = orange, .fill = pale_orange, .width = 1.5});
    sketch.line({-2.4, 0}, {2.4, 0}, stroke(black, 3));
    sketch.dot({1.05, 0}, 5, blue);
    sketch.dot({1.3, 0}, 5, vermilion);
    sketch.light({0, 2});
    return case_sketch("A point just inside the cone of 30° and one just outside: one step, or a soft edge.", sketch,
                       {-2.4, -0.5}, {2.4, 2.2});
}

CaseSketch narrow_spot() {
    PlaneSketch sketch;
    sketch.polygon({{0, 0}, {4, 0.12}, {4, -0.12}}, {.line = orange, .fill = pale_orange, .width = 1.5});
    sketch.line({4, -0.9}, {4, 0.9}, stroke(black, 3));
    sketch.dot({4, 0.16}, 5, vermilion);
    sketch.light({0, 0});
    sketch.words({1.8, 0}, "0.01°", {.aside = {0, -16}, .anchor = Anchor::center});
    return case_sketch("So narrow a cone has a cosine of 1 in float: everything ahead seems lit.", sketch, {-0.3, -1.2},
                       {4.3, 1.4});
}

CaseSketch three_points() {
    PlaneSketch sketch;
    std::vector<PlanePoint> arc;
    for (int i = 0; i <= 30; ++i) arc.push_back(towards(50 + 80.0 * i / 30, 2));
    sketch.path(arc, stroke(blue, 3));
    for (const double angle : {87.0, 90.0, 93.0}) sketch.dot(towards(angle, 2), 4);
    sketch.arrow({0, 2}, {0, 3}, stroke(blue));
    sketch.arrow({0, 2}, {0.5, 2.87}, stroke(vermilion));
    return case_sketch("Three points 1e-12 apart: of their differences only rounding is left, and the normal leans.",
                       sketch, {-1.6, 1.1}, {1.6, 3.2});
}

CaseSketch mach_bands() {
    PlaneSketch sketch;
    for (int i = 0; i < 5; ++i)
        sketch.line({0.8 * i, 0.4 + 0.45 * i}, {0.8 * (i + 1), 0.4 + 0.45 * i}, stroke(vermilion, 3));
    sketch.path({{0, 0.1}, {0.8, 0.75}, {1.6, 1.1}, {2.4, 1.7}, {3.2, 2.0}, {4, 2.3}}, stroke(blue, 3));
    sketch.arrow({0, 0}, {4.2, 0}, stroke(grey, 1.5));
    sketch.arrow({0, 0}, {0, 2.7}, stroke(grey, 1.5));
    sketch.words({0, 2.7}, "brightness", {.aside = {10, 8}});
    return case_sketch("Along a line: flat shading steps (orange), Gouraud's bends (blue); the eye sees both.", sketch,
                       {-0.2, -0.2}, {4.4, 2.9});
}

CaseSketch lost_highlight() {
    PlaneSketch sketch;
    sketch.polygon({{-2, -1}, {2, -1}, {0, 2}}, {.line = blue, .fill = pale_blue, .width = 2});
    for (const double size : {0.55, 0.4, 0.25})
        sketch.circle({0, -0.05}, size, filled(size > 0.5 ? "#fdecc8" : size > 0.3 ? "#ffdf80" : "#ffffff"));
    for (const PlanePoint corner : {PlanePoint{-2, -1}, {2, -1}, {0, 2}}) sketch.dot(corner, 6);
    return case_sketch("The highlight lies inside; Gouraud asks the three corners only, and they are dark.", sketch,
                       {-2.3, -1.2}, {2.3, 2.2});
}

CaseSketch normal_left_short() {
    PlaneSketch sketch;
    sketch.line({-2, 0}, {2, 0}, stroke(black, 3));
    sketch.arrow({-1.6, 0}, {-2.4, 1.4}, stroke(blue));
    sketch.arrow({1.6, 0}, {2.4, 1.4}, stroke(blue));
    sketch.arrow({0, 0}, {0, 1.4}, stroke(vermilion));
    sketch.line({-0.5, 1.61}, {0.5, 1.61}, stroke(grey, 1.5, dashed));
    sketch.words({0, 1.61}, "length 1", {.aside = {0, -8}, .anchor = Anchor::center});
    return case_sketch("The mean of two unit normals is too short: to the power 60 nothing is left.", sketch,
                       {-2.6, -0.4}, {2.6, 2.1});
}

CaseSketch leaf() {
    PlaneSketch sketch;
    sketch.line({-1.6, 0.04}, {1.6, 0.04}, stroke(blue, 3));
    sketch.line({-1.6, -0.04}, {1.6, -0.04}, stroke(green, 3));
    sketch.arrow({0, 0.04}, {0, 1.2}, stroke(blue));
    sketch.arrow({0, -0.04}, {0, -1.2}, stroke(green));
    sketch.dot({-1.6, 0}, 5);
    sketch.dot({1.6, 0}, 5);
    sketch.words({0, 1.2}, "**N**_{1} + **N**_{2} = 0", {.aside = {12, 8}});
    return case_sketch("Two triangles back to back share their vertices: their normals sum to nothing.", sketch,
                       {-2, -1.4}, {2.4, 1.4});
}

CaseSketch cube_corner() {
    PlaneSketch sketch;
    const PlanePoint o{0, 0}, right{1.5, 0.5}, left{-1.5, 0.5}, down{0, -1.5};
    const auto sum = [](PlanePoint a, PlanePoint b) { return PlanePoint{a.x + b.x, a.y + b.y}; };
    for (const auto& [a, b] : {std::pair{right, left}, {left, down}, {down, right}})
        sketch.polygon({o, a, sum(a, b), b}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.line(o, sum(right, left), stroke(blue, 1.5));
    sketch.line(o, sum(left, down), stroke(blue, 1.5));
    sketch.line(down, right, stroke(blue, 1.5));
    sketch.dot(o, 5);
    sketch.words({0.1, 0.95}, "2", {.aside = {-40, 14}});
    sketch.words({0, 0}, "2", {.aside = {-56, 56}});
    sketch.words({0, 0}, "1", {.aside = {22, 40}});
    return case_sketch("Faces split into triangles count once or twice at the corner: equal weights lean the normal.",
                       sketch, {-2, -1.7}, {2, 1.3});
}

PlaneSketch ball_over_floor(const std::string& fill) {
    PlaneSketch sketch;
    sketch.line({-2.2, 0}, {2.2, 0}, stroke(black, 3));
    sketch.circle({0, 1.1}, 0.5, {.line = black, .fill = fill, .width = 2});
    sketch.dot({0, 0}, 5, vermilion);
    return sketch;
}

CaseSketch no_shadow() {
    PlaneSketch sketch = ball_over_floor(pale_blue);
    sketch.arrow({0, 2.4}, {0, 1.65}, stroke(orange));
    sketch.line({0, 0.6}, {0, 0.1}, stroke(orange, 2, dotted));
    sketch.light({0, 2.4});
    return case_sketch("A local model asks nobody: the point is as bright as without the ball.", sketch, {-2.2, -0.4},
                       {2.2, 2.6});
}

CaseSketch dark_emitter() {
    return case_sketch("The ball glows, but it is no light of the list: the point below gets nothing from it.",
                       ball_over_floor("#ffd93b"), {-2.2, -0.4}, {2.2, 2.6});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"EVEN-POWER", even_power},
            {"HIGHLIGHT-CUT", highlight_cut},
            {"LIGHT-ON-SURFACE", light_on_surface},
            {"SPOT-EDGE", spot_edge},
            {"NARROW-SPOT", narrow_spot},
            {"THREE-POINTS", three_points},
            {"MACH-BANDS", mach_bands},
            {"LOST-HIGHLIGHT", lost_highlight},
            {"NORMAL-LEFT-SHORT", normal_left_short},
            {"LEAF", leaf},
            {"CUBE-CORNER", cube_corner},
            {"NO-SHADOW", no_shadow},
            {"DARK-EMITTER", dark_emitter}};
}

}  // namespace raylab::lighting
