#include "case_sketches.h"

namespace raylab::coherence {

namespace {

using namespace plane_ink;

CaseSketch item_edge() {
    PlaneSketch sketch;
    sketch.polygon({{-0.6, -1.2}, {2.3, -0.6}, {0.4, 1.4}}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.polygon({{-2.3, 0.9}, {-0.6, -1.2}, {0.4, 1.4}}, {.line = green, .fill = pale_green, .width = 2});
    sketch.circle({-0.05, 0.23}, 0.45, stroke(grey, 1.5, dashed));
    sketch.dot({-0.13, 0.26}, 5, vermilion);
    return case_sketch(
        "Two triangles of a ball and a pixel's middle on their edge: rounding by less than the circle decides which is "
        "seen.",
        sketch, {-2.4, -1.4}, {2.4, 1.6});
}

CaseSketch item_depth() {
    PlaneSketch sketch;
    sketch.line({-2, -0.12}, {2, 0.12}, stroke(blue, 3));
    sketch.line({-2, 0.12}, {2, -0.12}, stroke(green, 3));
    for (const double x : {-0.5, -0.2, 0.1, 0.4}) sketch.arrow({x, 1.3}, {x, 0.08}, stroke(orange, 1.8));
    sketch.words({-2, 1.2}, "the eye's rays");
    return case_sketch("Two sheets cross, nearly in one plane: near the crossing, depths in float are equal.", sketch,
                       {-2.2, -0.9}, {2.2, 1.5});
}

CaseSketch item_behind() {
    PlaneSketch sketch;
    sketch.line({-1.8, -0.9}, {2.6, -0.9}, stroke(blue, 4));
    sketch.line({0, 1.1}, {0, -1.3}, stroke(grey, 1.5, dashed));
    sketch.arrow({0, 0}, {1.9, -0.85}, stroke(orange, 2));
    sketch.arrow({0, 0}, {1.4, 0.5}, stroke(orange, 2));
    sketch.dot({-1.8, -0.9}, 5, vermilion);
    sketch.dot({0, 0}, 5);
    sketch.words({0, 0}, "eye", {.aside = {-10, -8}, .anchor = Anchor::right});
    sketch.words({-1.8, -0.9}, "a corner behind it", {.aside = {-4, 26}, .color = vermilion});
    return case_sketch("One corner of the floor lies behind the eye: projected, it comes out on the wrong side.",
                       sketch, {-2, -1.5}, {2.7, 1.2});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"ITEM-EDGE", item_edge}, {"ITEM-DEPTH", item_depth}, {"ITEM-BEHIND", item_behind}};
}

}  // namespace raylab::coherence
