#include "drawings.h"

#include "polygon_pictures.h"

#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace raylab {

namespace {

using namespace plane_ink;

// Twice the area of the triangle from `at` to p and q; its sign tells the side on which `at` lies.
double area(PlanePoint at, PlanePoint p, PlanePoint q) {
    return (p.x - at.x) * (q.y - at.y) - (p.y - at.y) * (q.x - at.x);
}

constexpr PlanePoint a{1.2, 0.9}, b{6.2, 1.6}, c{3.0, 5.2};

std::string signs_at(PlanePoint at) {
    const auto sign = [&](PlanePoint p, PlanePoint q) { return area(at, p, q) > 0 ? "+" : "–"; };
    return fmt::format("{} {} {}", sign(b, c), sign(c, a), sign(a, b));
}

void add_corners(PlaneSketch& sketch, double right) {
    const auto name = [&](PlanePoint at, const std::string& words, Point2 aside) {
        sketch.dot({at.x + right, at.y}, 5);
        sketch.words({at.x + right, at.y}, words, {.aside = aside, .anchor = Anchor::center, .height = 15});
    };
    name(a, "**a**", {-20, 14});
    name(b, "**b**", {20, 10});
    name(c, "**c**", {-20, -6});
}

// The lines through the edges make seven regions; the signs are those of w_a, w_b and w_c.
void add_signs(PlaneSketch& sketch) {
    sketch.polygon({a, b, c}, {.line = "", .fill = pale_green});
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}}) {
        const Point2 far{1.6 * (q.x - p.x), 1.6 * (q.y - p.y)};
        sketch.line({q.x - far.x, q.y - far.y}, {p.x + far.x, p.y + far.y},
                    {.line = grey, .width = 1.2, .dash = dashed});
    }
    sketch.polygon({a, b, c}, {.line = black, .width = 2.5});
    for (const PlanePoint at :
         {PlanePoint{3.4, 2.4}, {5.7, 4.3}, {0.6, 3.4}, {4.2, 0.3}, {-0.35, -0.25}, {7.6, 0.8}, {2.4, 6.5}}) {
        const std::string signs = signs_at(at);
        sketch.words(at, signs,
                     {.anchor = Anchor::center, .color = signs == "+ + +" ? green : vermilion, .height = 17});
    }
    add_corners(sketch, 0);
    sketch.words({3.4, -0.85}, "the signs of *w*_{a}, *w*_{b}, *w*_{c}", {.anchor = Anchor::center, .height = 14});
}

void add_areas(PlaneSketch& sketch, double right) {
    const auto at = [&](PlanePoint p) { return PlanePoint{p.x + right, p.y}; };
    const PlanePoint inside{3.2, 2.2};
    const auto part = [&](PlanePoint p, PlanePoint q, const char* fill, const std::string& words) {
        sketch.polygon({at(inside), at(p), at(q)}, {.line = grey, .fill = fill, .width = 1.5});
        sketch.words(at({(inside.x + p.x + q.x) / 3, (inside.y + p.y + q.y) / 3}), words,
                     {.aside = {0, 7}, .anchor = Anchor::center, .height = 15, .halo = ""});
    };
    part(b, c, pale_blue, "*w*_{a}");
    part(c, a, pale_orange, "*w*_{b}");
    part(a, b, pale_green, "*w*_{c}");
    sketch.polygon({at(a), at(b), at(c)}, {.line = black, .width = 2.5});
    sketch.dot(at(inside), 6, vermilion);
    add_corners(sketch, right);
    const double whole = area(a, b, c);
    sketch.words(at({3.4, -0.85}),
                 fmt::format("shares of the whole: {:.2f}, {:.2f}, {:.2f}", area(inside, b, c) / whole,
                             area(inside, c, a) / whole, area(inside, a, b) / whole),
                 {.anchor = Anchor::center, .height = 14});
}

// The rule of README (6): an end on the half-line itself counts as below.
bool straddles(PlanePoint p, PlanePoint q, double y) { return (p.y > y) != (q.y > y); }

// A piece of a border on the half-line to the right of the origin, moved to the right.
struct Case {
    std::string name;
    std::vector<PlanePoint> border;
};

void add_case(PlaneSketch& sketch, const Case& one, double right) {
    const auto at = [&](PlanePoint p) { return PlanePoint{p.x + right, p.y}; };
    sketch.arrow(at({-1.9, 0}), at({1.9, 0}), {.line = grey, .width = 1.8});
    sketch.dot(at({-1.9, 0}), 5.5, vermilion);
    int crossings = 0;
    for (std::size_t i = 0; i + 1 < one.border.size(); ++i) {
        const PlanePoint p = one.border[i], q = one.border[i + 1];
        const bool counts = straddles(p, q, 0);
        crossings += counts;
        sketch.line(at(p), at(q), {.line = counts ? blue : black, .width = counts ? 5.0 : 2.0});
    }
    for (const PlanePoint& corner : one.border)
        if (corner.y == 0) sketch.dot(at(corner), 5.5);
    sketch.words(at({0, -2}), fmt::format("{}: {}", one.name, crossings), {.anchor = Anchor::center, .height = 14});
}

}  // namespace

PlaneDrawing draw_edge_signs() {
    PlaneSketch sketch;
    add_signs(sketch);
    add_areas(sketch, 9.6);
    return sketch.drawing({-1.6, -1.3}, {16.6, 7.0}, 960, 460);
}

PlaneDrawing draw_crossings() {
    PlaneSketch sketch;
    std::vector<PlanePoint> corners;
    for (const Vec3f& corner : flat_star().vertices) corners.push_back({corner.x, corner.y});
    const auto after = [&](std::size_t i) { return corners[(i + 1) % corners.size()]; };
    for (std::size_t i = 0; i < corners.size(); ++i) sketch.line(corners[i], after(i), {.line = black, .width = 2.5});
    for (const PlanePoint from : {PlanePoint{-0.03, 0.75}, {-1.0, 0.58}, {-0.3, 0.1}, {0.0, -0.72}, {-0.62, -0.87}}) {
        sketch.arrow(from, {1.3, from.y}, {.line = grey, .width = 1.5});
        int crossings = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const PlanePoint p = corners[i], q = after(i);
            if (!straddles(p, q, from.y)) continue;
            const double x = p.x + (from.y - p.y) * (q.x - p.x) / (q.y - p.y);
            if (x < from.x) continue;
            ++crossings;
            sketch.add(PlaneDrawing::Figure{PlaneCircle{{x, from.y}, 0.035}, {.line = vermilion, .width = 2}});
        }
        const bool inside = crossings % 2 == 1;
        sketch.dot(from, 6, inside ? blue : black);
        sketch.words({1.36, from.y}, fmt::format("{}: {}", crossings, inside ? "inside" : "outside"),
                     {.aside = {0, 6}, .height = 14});
    }
    return sketch.drawing({-1.25, -1.1}, {1.95, 1.25}, 640, 480);
}

PlaneDrawing draw_half_open() {
    const std::array<Case, 4> cases{{{"going on upward", {{-0.5, -1.3}, {0, 0}, {0.6, 1.3}}},
                                     {"both above", {{-0.7, 1.3}, {0, 0}, {0.7, 1.3}}},
                                     {"both below", {{-0.7, -1.3}, {0, 0}, {0.7, -1.3}}},
                                     {"a level edge", {{-0.9, -1.3}, {-0.6, 0}, {0.6, 0}, {0.9, 1.3}}}}};
    PlaneSketch sketch;
    for (std::size_t i = 0; i < cases.size(); ++i) add_case(sketch, cases[i], 4.8 * static_cast<double>(i));
    return sketch.drawing({-2.3, -2.3}, {16.7, 1.6}, 960, 260);
}

}  // namespace raylab
