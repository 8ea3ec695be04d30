#include "case_sketches.h"

#include <cmath>

namespace raylab::recursion {

namespace {

using namespace plane_ink;

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
    return {{"HALL-OF-MIRRORS", hall_of_mirrors}, {"PANES", panes}, {"RAY-BOMB", ray_bomb}};
}

}  // namespace raylab::recursion
