#include "drawings.h"

#include "raylab/report/plane/plane_angle.h"
#include "raylab/report/plane/plane_sketch.h"

#include <cmath>
#include <functional>
#include <string>

namespace raylab {

namespace {

using namespace plane_ink;

// How words beside a point are written.
PlaneWords beside(const std::string& color, Point2 aside, Anchor anchor = Anchor::center) {
    return {.aside = aside, .anchor = anchor, .color = color, .height = 14};
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
    sketch.circle(center, radius, {.line = blue, .fill = "#eaf4fb", .width = 2.5});
    sketch.line(origin, center, stroke(grey, 1.5, dashed));
    sketch.line(center, {t1, 0}, stroke(blue, 1.8));
    sketch.line(center, nearest, stroke(green));
    sketch.add(right_angle(nearest, center, {0, 0}, 0.28, {.line = black, .width = 1.2}));
    sketch.arrow(origin, {10.6, 0}, stroke(vermilion));
    sketch.dot(origin, 6, vermilion);
    sketch.dot(center, 5, blue);
    sketch.words(origin, "*O*", beside(vermilion, {-4, -14}));
    sketch.words({10.6, 0}, "*O* + *t* **d**", beside(vermilion, {-6, -14}));
    sketch.words(center, "*C*", beside(blue, {0, -14}));
    sketch.words({2.6, 0.5}, "–**f**", beside(grey, {0, -14}));
    sketch.words({center_x, center_y / 2}, "**ℓ**", beside(green, {-16, 6}));
    sketch.words({(center_x + t1) / 2, center_y / 2}, "*r*", beside(blue, {16, -2}));
    for (const double t : {t0, t1}) sketch.dot({t, 0}, 6, black);
}

void add_graph(PlaneSketch& sketch, double t0, double t1) {
    for (const double t : {t0, -b, t1})
        sketch.line({t, 0}, {t, t == -b ? on_graph(t).y : axis_y}, stroke(grey, 1.2, dotted));
    sketch.arrow({-0.2, axis_y}, {10.6, axis_y}, stroke(black, 1.8));
    std::vector<PlanePoint> curve;
    for (double t = 2.45; t <= 9.551; t += 0.05) curve.push_back(on_graph(t));
    sketch.path(curve, stroke(blue));
    for (const double t : {t0, t1}) sketch.dot({t, axis_y}, 6, black);
    sketch.dot(on_graph(-b), 4.5, blue);
    sketch.words({t0, axis_y}, "*t*_{0}", beside(black, {-18, -12}));
    sketch.words({t1, axis_y}, "*t*_{1}", beside(black, {20, -12}));
    sketch.words({10.6, axis_y}, "*t*", beside(black, {-4, 24}));
    sketch.words(on_graph(-b), "lowest at *t* = –*b* / *a*: the value –*D* / *a*", beside(blue, {0, 30}));
    sketch.words({9.6, axis_y + 1.6}, "*a* *t*^{2} + 2 *b* *t* + *c*", beside(blue, {6, 0}, Anchor::left));
    constexpr double between = axis_y + 0.55;
    for (const double t : {t0, t1}) {
        sketch.arrow({-b, between}, {t, between}, stroke(green, 1.8));
        sketch.words({(t - b) / 2, between}, "√*D* / *a*", beside(green, {0, -12}));
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
    sketch.line({x, -0.25}, {x, axis_length + 0.4}, stroke(grey, 1.2, dashed));
    sketch.path(right, stroke(blue, 2.8));
    sketch.path(left, stroke(blue, 2.8));
    sketch.words({x, 0}, profile.name, beside(black, {0, 42}));
}

}  // namespace

PlaneDrawing draw_ray_and_sphere() {
    PlaneSketch sketch;
    const double t0 = -b - std::sqrt(discriminant), t1 = -b + std::sqrt(discriminant);
    add_sphere(sketch, t0, t1);
    add_graph(sketch, t0, t1);
    return sketch.drawing({-0.6, -5.7}, {12.2, 3.3}, 720, 506);
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
    sketch.arrow(base, {0, axis_length}, stroke(vermilion));
    sketch.line(foot, point, stroke(green));
    sketch.add(right_angle(foot, point, {0, axis_length}, 0.22, {.line = black, .width = 1.2}));
    sketch.dot(base, 5.5, black);
    sketch.dot(point, 5.5, black);
    sketch.words(base, "*B*", beside(black, {-16, 4}));
    sketch.words({0, axis_length}, "**A**", beside(vermilion, {16, 4}));
    sketch.words({rho / 2, foot.y}, "ϱ", beside(green, {2, -8}));
    sketch.words(point, "*P*", beside(black, {16, 2}));
    sketch.words({0, foot.y / 2}, "*s* **A**", beside(vermilion, {-26, 6}));
    return sketch.drawing({-2.4, -1.1}, {17.4, 4.9}, 960, 350);
}

}  // namespace raylab
