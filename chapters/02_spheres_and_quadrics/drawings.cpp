#include "drawings.h"

#include "raylab/report/plane/plane_angle.h"
#include "raylab/report/plane/plane_sketch.h"

#include <cmath>
#include <functional>
#include <string>

namespace raylab {

namespace {

using Arrow = PlaneDrawing::Arrow;
using Dash = PlaneStyle::Dash;
using Dot = PlaneDrawing::Dot;
using Figure = PlaneDrawing::Figure;
using Path = PlaneDrawing::Path;
using Text = PlaneDrawing::Text;

using namespace plane_ink;

Text words(PlanePoint at, const std::string& text, const std::string& color, Point2 aside,
           Anchor anchor = Anchor::center) {
    return {.at = at, .words = text, .height = 14, .color = color, .anchor = anchor, .aside = aside, .halo = "#ffffff"};
}

// The ray starts at the origin of the drawing and runs to the right, one unit for each t; the sphere's center is above.
constexpr double center_x = 6, center_y = 1.15, radius = 2.1;
constexpr double b = -center_x, c = center_x * center_x + center_y * center_y - radius * radius,
                 discriminant = b * b - c;

// The graph below: its axis, and how much lower it draws a value.
constexpr double axis_y = -3.6, graph_scale = 0.24;

PlanePoint on_graph(double t) { return {t, axis_y + graph_scale * (t * t + 2 * b * t + c)}; }

void add_sphere(PlaneSketch& sketch, double t0, double t1) {
    const PlanePoint center{center_x, center_y}, nearest{-b, 0}, origin{0, 0};
    sketch.add(Figure{PlaneCircle{center, radius}, {.line = blue, .fill = "#eaf4fb", .width = 2.5}});
    sketch.add(Path{{origin, center}, {.line = grey, .width = 1.5, .dash = Dash::dashed}});
    sketch.add(Path{{center, {t1, 0}}, {.line = blue, .width = 1.8}});
    sketch.add(Path{{center, nearest}, {.line = green, .width = 2.5}});
    sketch.add(right_angle(nearest, center, {0, 0}, 0.28, {.line = black, .width = 1.2}));
    sketch.add(Arrow{origin, {10.6, 0}, {.line = vermilion, .width = 2.5}});
    sketch.add(Dot{origin, 6, vermilion});
    sketch.add(Dot{center, 5, blue});
    sketch.add(words(origin, "*O*", vermilion, {-4, -14}));
    sketch.add(words({10.6, 0}, "*O* + *t* **d**", vermilion, {-6, -14}));
    sketch.add(words(center, "*C*", blue, {0, -14}));
    sketch.add(words({2.6, 0.5}, "–**f**", grey, {0, -14}));
    sketch.add(words({center_x, center_y / 2}, "**ℓ**", green, {-16, 6}));
    sketch.add(words({(center_x + t1) / 2, center_y / 2}, "*r*", blue, {16, -2}));
    for (const double t : {t0, t1}) sketch.add(Dot{{t, 0}, 6, black});
}

void add_graph(PlaneSketch& sketch, double t0, double t1) {
    for (const double t : {t0, -b, t1})
        sketch.add(
            Path{{{t, 0}, {t, t == -b ? on_graph(t).y : axis_y}}, {.line = grey, .width = 1.2, .dash = Dash::dotted}});
    sketch.add(Arrow{{-0.2, axis_y}, {10.6, axis_y}, {.line = black, .width = 1.8}});
    std::vector<PlanePoint> curve;
    for (double t = 2.45; t <= 9.551; t += 0.05) curve.push_back(on_graph(t));
    sketch.add(Path{std::move(curve), {.line = blue, .width = 2.5}});
    for (const double t : {t0, t1}) sketch.add(Dot{{t, axis_y}, 6, black});
    sketch.add(Dot{on_graph(-b), 4.5, blue});
    sketch.add(words({t0, axis_y}, "*t*_{0}", black, {-18, -12}));
    sketch.add(words({t1, axis_y}, "*t*_{1}", black, {20, -12}));
    sketch.add(words({10.6, axis_y}, "*t*", black, {-4, 24}));
    sketch.add(words(on_graph(-b), "lowest at *t* = –*b* / *a*: the value –*D* / *a*", blue, {0, 30}));
    sketch.add(words({9.6, axis_y + 1.6}, "*a* *t*^{2} + 2 *b* *t* + *c*", blue, {6, 0}, Anchor::left));
    constexpr double between = axis_y + 0.55;
    for (const double t : {t0, t1}) {
        sketch.add(Arrow{{-b, between}, {t, between}, {.line = green, .width = 1.8}});
        sketch.add(words({(t - b) / 2, between}, "√*D* / *a*", green, {0, -12}));
    }
}

// A surface of revolution cut along its axis: its radius at each height.
struct Profile {
    std::string name;
    std::function<double(double)> squared_radius;  // q(s)
};

constexpr double axis_length = 4;

void add_profile(PlaneSketch& sketch, const Profile& profile, double x) {
    std::vector<PlanePoint> right, left;
    for (int i = 0; i <= 60; ++i) {
        const double s = i * i / 3600.0, rho = std::sqrt(profile.squared_radius(s));
        right.push_back({x + rho, axis_length * s});
        left.push_back({x - rho, axis_length * s});
    }
    sketch.add(Path{{{x, -0.25}, {x, axis_length + 0.4}}, {.line = grey, .width = 1.2, .dash = Dash::dashed}});
    sketch.add(Path{right, {.line = blue, .width = 2.8}});
    sketch.add(Path{left, {.line = blue, .width = 2.8}});
    sketch.add(words({x, 0}, profile.name, black, {0, 42}));
}

}  // namespace

PlaneDrawing draw_ray_and_sphere() {
    PlaneSketch sketch;
    const double t0 = -b - std::sqrt(discriminant), t1 = -b + std::sqrt(discriminant);
    add_sphere(sketch, t0, t1);
    add_graph(sketch, t0, t1);
    return {.low = {-0.6, -5.9}, .high = {12.2, 3.5}, .width = 900, .height = 660, .marks = sketch.marks()};
}

PlaneDrawing draw_revolution() {
    PlaneSketch sketch;
    const Profile cone{"cone", [](double s) { return std::pow(1.7 - 1.2 * s, 2); }};
    add_profile(sketch, {"cylinder", [](double) { return 1.69; }}, 4.4);
    add_profile(sketch, cone, 8.1);
    add_profile(sketch, {"paraboloid", [](double s) { return 2.6 * s; }}, 11.8);
    add_profile(sketch, {"hyperboloid", [](double s) { return 0.3 + 2.2 * std::pow(2 * s - 1, 2); }}, 15.6);
    add_profile(sketch, {"", cone.squared_radius}, 0);
    const double s = 0.62, rho = std::sqrt(cone.squared_radius(s));
    const PlanePoint base{0, 0}, foot{0, axis_length * s}, point{rho, axis_length * s};
    sketch.add(Arrow{base, {0, axis_length}, {.line = vermilion, .width = 2.5}});
    sketch.add(Path{{foot, point}, {.line = green, .width = 2.5}});
    sketch.add(right_angle(foot, point, {0, axis_length}, 0.22, {.line = black, .width = 1.2}));
    sketch.add(Dot{base, 5.5, black});
    sketch.add(Dot{point, 5.5, black});
    sketch.add(words(base, "*B*", black, {-16, 4}));
    sketch.add(words({0, axis_length}, "**A**", vermilion, {16, 4}));
    sketch.add(words({rho / 2, foot.y}, "ϱ", green, {2, -8}));
    sketch.add(words(point, "*P*", black, {16, 2}));
    sketch.add(words({0, foot.y / 2}, "*s* **A**", vermilion, {-26, 6}));
    return {.low = {-2.4, -1.1}, .high = {17.4, 4.9}, .width = 960, .height = 350, .marks = sketch.marks()};
}

}  // namespace raylab
