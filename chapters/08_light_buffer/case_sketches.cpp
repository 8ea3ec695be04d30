#include "case_sketches.h"

namespace raylab::lantern {

namespace {

using namespace plane_ink;

// The light in its cube, whose faces have four cells each.
PlaneSketch cube_about(PlanePoint light) {
    PlaneSketch sketch;
    const auto at = [&](double x, double y) { return PlanePoint{light.x + x, light.y + y}; };
    sketch.rectangle(at(-1, -1), at(1, 1), stroke(blue, 2));
    for (const double k : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        sketch.dot(at(-1, k), 3, blue);
        sketch.dot(at(1, k), 3, blue);
        sketch.dot(at(k, -1), 3, blue);
        sketch.dot(at(k, 1), 3, blue);
    }
    return sketch;
}

CaseSketch light_cell() {
    PlaneSketch sketch = cube_about({0, 0});
    sketch.line({0, 0}, {3, 1.5}, stroke(light_grey, 1.5));
    sketch.line({0, 0}, {3, 0}, stroke(light_grey, 1.5));
    sketch.circle({2, 0.25}, 0.12, {.line = vermilion, .fill = pale_orange, .width = 2});
    sketch.arrow({3, 0.375}, {0.1, 0.0125}, stroke(orange, 2));
    sketch.line({0, 0}, {3, 0.75}, stroke(grey, 1.5, dashed));
    sketch.light({0, 0});
    return case_sketch("A list made along the cell's middle (dashed) misses what is smaller than the cell.", sketch,
                       {-1.2, -1.2}, {3.1, 1.6});
}

CaseSketch light_inside() {
    PlaneSketch sketch = cube_about({0, 0});
    sketch.rectangle({-1.6, -1.4}, {2.2, 1.4}, stroke(black, 4));
    sketch.arrow({2.15, 0.9}, {0.1, 0.05}, stroke(orange, 2));
    sketch.light({0, 0});
    sketch.words({2.2, 1.4}, "a closed box", {.aside = {-10, 24}, .anchor = Anchor::right});
    return case_sketch("The light stands inside a box: the walls are in every cell's list, on all sides.", sketch,
                       {-1.8, -1.6}, {2.4, 1.6});
}

CaseSketch light_moved() {
    PlaneSketch sketch = cube_about({0, 0});
    sketch.light({0, 0}, "#e8e8e8");
    sketch.arrow({0.15, 0}, {1.8, 0.5}, stroke(vermilion));
    sketch.light({2, 0.55});
    sketch.words({2, 0.55}, "the light", {.aside = {0, -16}, .anchor = Anchor::center});
    return case_sketch("The light has left the cube: its lists say nothing, and the buffer must know that.", sketch,
                       {-1.2, -1.2}, {2.8, 1.2});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"LIGHT-CELL", light_cell}, {"LIGHT-INSIDE", light_inside}, {"LIGHT-MOVED", light_moved}};
}

}  // namespace raylab::lantern
