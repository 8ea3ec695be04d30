#include "case_sketches.h"

#include <cmath>

namespace raylab::recursion {

namespace {

using namespace plane_ink;

constexpr double pi = 3.14159265358979;

PlanePoint towards(double degrees, double length) {
    return {length * std::cos(degrees * pi / 180), length * std::sin(degrees * pi / 180)};
}

PlaneSketch glass_below() {
    PlaneSketch sketch;
    sketch.rectangle({-2.2, -1.7}, {2.2, 0}, filled(pale_blue));
    sketch.line({-2.2, 0}, {2.2, 0}, stroke(blue, 3));
    sketch.line({0, -1.5}, {0, 1.2}, stroke(grey, 1.5, dashed));
    return sketch;
}

CaseSketch tir_edge() {
    PlaneSketch sketch = glass_below();
    const double critical = 41.81;
    sketch.arrow(towards(-90 - critical, 1.9), {0, 0}, stroke(orange));
    sketch.arrow({0, 0}, {2, 0.06}, stroke(vermilion));
    sketch.arrow({0, 0}, towards(-90 + critical, 1.7), stroke(blue));
    sketch.words({0, -0.8}, "41.81°", {.aside = {-8, 22}, .anchor = Anchor::right});
    return case_sketch("At the critical angle the ray out runs along the glass: is there one, or is all reflected?",
                       sketch, {-2.2, -1.7}, {2.2, 1.2});
}

CaseSketch grazing() {
    PlaneSketch sketch;
    sketch.rectangle({-2.2, -1}, {2.2, 0}, filled(pale_blue));
    for (const double y : {-1.0, 0.0}) sketch.line({-2.2, y}, {2.2, y}, stroke(blue, 3));
    sketch.arrow({-2.2, 0.25}, {-0.6, 0.01}, stroke(orange));
    sketch.arrow({-0.6, 0}, {0.3, -1}, stroke(green));
    sketch.arrow({0.3, -1}, {2.1, -1.27}, stroke(vermilion));
    return case_sketch("Into a plate and out again at 89.99°: the last ray must be parallel to the first.", sketch,
                       {-2.2, -1.7}, {2.2, 0.8});
}

CaseSketch hall_of_mirrors() {
    PlaneSketch sketch;
    for (const double x : {-1.5, 1.5}) sketch.line({x, -1.2}, {x, 1.2}, stroke(blue, 5));
    PlanePoint at{0, -1};
    for (int i = 0; i < 5; ++i) {
        const PlanePoint next{i % 2 == 0 ? 1.5 : -1.5, at.y + (i == 0 ? 0.2 : 0.4)};
        sketch.arrow(at, next, stroke(orange, 3.0 * std::pow(0.8, i) + 0.3));
        at = next;
    }
    sketch.dot({0, -1}, 5);
    sketch.words({0, -1}, "eye", {.aside = {-10, 6}, .anchor = Anchor::right});
    return case_sketch("Each bounce brings 0.9 of the one before; to cut at a depth leaves a known part out.", sketch,
                       {-1.9, -1.3}, {1.9, 1.3});
}

CaseSketch panes() {
    PlaneSketch sketch;
    for (int i = 0; i < 4; ++i)
        sketch.rectangle({-1.2 + 0.8 * i, -1}, {-0.95 + 0.8 * i, 1}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.arrow({-2, 0.3}, {2.4, 0.3}, stroke(orange, 3));
    for (int i = 0; i < 4; ++i) sketch.arrow({-1.2 + 0.8 * i, 0.3}, {-1.5 + 0.8 * i, 0.75}, stroke(vermilion, 1.5));
    return case_sketch("Each pane has two surfaces: 16 of them use up 32 depths before anything is seen.", sketch,
                       {-2, -1.1}, {2.4, 1.1});
}

CaseSketch ray_bomb() {
    PlaneSketch sketch;
    sketch.line({0, 2}, {-1, 1.2}, stroke(blue, 3));
    sketch.line({0, 2}, {1, 1.2}, stroke(green, 3));
    for (const double x : {-1.0, 1.0})
        for (const double side : {-0.5, 0.5}) {
            sketch.line({x, 1.2}, {x + side, 0.4}, stroke(side < 0 ? blue : green, 2));
            for (const double half : {-0.25, 0.25}) {
                sketch.line({x + side, 0.4}, {x + side + half, -0.3}, stroke(half < 0 ? blue : green, 1.3));
                sketch.line({x + side + half, -0.3}, {x + side + half, -0.6}, stroke(grey, 1.2, dotted));
            }
        }
    sketch.dot({0, 2}, 5);
    sketch.words({0, -0.6}, "2^{15} − 1 rays", {.aside = {0, 24}, .anchor = Anchor::center});
    return case_sketch("In a closed chamber of glass every ray becomes two.", sketch, {-2, -1.1}, {2, 2.2});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"TIR-EDGE", tir_edge},
            {"GRAZING", grazing},
            {"HALL-OF-MIRRORS", hall_of_mirrors},
            {"PANES", panes},
            {"RAY-BOMB", ray_bomb}};
}

}  // namespace raylab::recursion
