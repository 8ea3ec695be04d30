#include "case_sketches.h"

namespace raylab {

namespace {

using namespace plane_ink;

constexpr PlaneStyle shape{.line = blue, .fill = pale_blue, .width = 2};

CaseSketch floor() {
    PlaneSketch sketch;
    sketch.circle({0, -30}, 30, shape);
    sketch.line({-3, 0.12}, {3, 0.12}, stroke(vermilion, 2, dashed));
    sketch.arrow({-2.2, 1.3}, {0.5, 0.02}, stroke(orange, 2));
    sketch.dot({-2.2, 1.3}, 5);
    sketch.words({-2.2, 1.3}, "eye", {.aside = {10, -4}});
    sketch.words({3, 0.12}, "the floor in float", {.aside = {0, -10}, .anchor = Anchor::right, .color = vermilion});
    return case_sketch("The ball is ten million times as large as the eye is high: rounding lifts or lowers the floor.",
                       sketch, {-2.8, -1.4}, {2.8, 2});
}

}  // namespace

CaseSketches case_sketches() { return {{"SPHERE-FLOOR", floor}}; }

}  // namespace raylab
