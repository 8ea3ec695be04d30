#include "case_sketches.h"

namespace raylab {

namespace {

using namespace plane_ink;

constexpr PlaneStyle shape{.line = blue, .fill = pale_blue, .width = 2};

// A cylinder of radius 1 from the side.
PlaneSketch cylinder() {
    PlaneSketch sketch;
    sketch.rectangle({-1, -1}, {1, 0.6}, shape);
    return sketch;
}

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

CaseSketch rim() {
    PlaneSketch sketch = cylinder();
    sketch.arrow({-2.2, 1.5}, {-1.06, 0.65}, stroke(vermilion));
    sketch.dot({-1, 0.6}, 5);
    return case_sketch("The ray aims at the rim, where side and cap meet: neither may leave it to the other.", sketch,
                       {-2.4, -1.2}, {2, 1.8});
}

CaseSketch apex() {
    PlaneSketch sketch;
    sketch.polygon({{-1, -1}, {1, -1}, {0, 1}}, shape);
    sketch.arrow({-2.2, 1.5}, {-0.08, 1.02}, stroke(vermilion));
    sketch.arrow({0, 1}, {2, 0.55}, stroke(grey, 2, dashed));
    sketch.dot({0, 1}, 5);
    return case_sketch("Through the apex of a cone both roots are one: the sign of D is a matter of rounding.", sketch,
                       {-2.4, -1.2}, {2.2, 1.8});
}

CaseSketch far_quadric() {
    PlaneSketch sketch;
    sketch.rectangle({1.7, -0.3}, {2.1, 0.3}, shape);
    sketch.arrow({-2.4, 0.28}, {2.5, 0.31}, stroke(orange, 2));
    sketch.dot({-2.4, 0.28}, 5);
    sketch.words({0, 0.3}, "1000 radii", {.aside = {0, 26}, .anchor = Anchor::center});
    return case_sketch("From 1000 radii away the squares of distances agree in all digits but the last ones.", sketch,
                       {-2.6, -1}, {2.6, 1});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"SPHERE-FLOOR", floor}, {"QUADRIC-RIM", rim}, {"QUADRIC-APEX", apex}, {"FAR-QUADRIC", far_quadric}};
}

}  // namespace raylab
