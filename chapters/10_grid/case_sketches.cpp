#include "case_sketches.h"

namespace raylab::grids {

namespace {

using namespace plane_ink;

PlaneSketch cells(int columns, int rows) {
    PlaneSketch sketch;
    for (int x = 0; x <= columns; ++x) sketch.line({double(x), 0}, {double(x), double(rows)}, stroke(light_grey, 1.5));
    for (int y = 0; y <= rows; ++y) sketch.line({0, double(y)}, {double(columns), double(y)}, stroke(light_grey, 1.5));
    return sketch;
}

CaseSketch drift() {
    PlaneSketch sketch;
    sketch.add(PlanePolygon{{{2, 1}, {3, 1}, {3, 2}, {2, 2}}}, filled("#fbd9c5"));
    sketch.add(cells(4, 3).marks());
    sketch.arrow({-0.4, -0.1}, {4.3, 2.9}, stroke(blue));
    sketch.path({{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {1.5, 2.5}, {2.5, 2.5}, {3.5, 2.5}}, stroke(vermilion, 2, dashed));
    return case_sketch("The sum of many steps drifts: the walk (dashed) turns too early, and misses a cell of the ray.",
                       sketch, {-0.5, -0.3}, {4.5, 3.2});
}

CaseSketch mailbox() {
    PlaneSketch sketch = cells(4, 3);
    sketch.polygon({{0.2, 0.4}, {3.8, 1.9}, {3.8, 2.3}, {0.2, 0.8}}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.circle({2.05, 1.07}, 0.13, {.line = green, .fill = pale_green, .width = 2});
    sketch.arrow({-0.4, 0.05}, {4.3, 2.2}, stroke(orange, 2));
    sketch.dot({3.35, 1.76}, 5, vermilion);
    return case_sketch(
        "The plank is tested in its first cell, but hit in a later one (dot): the small ball before it is not yet "
        "known.",
        sketch, {-0.5, -0.2}, {4.5, 3.2});
}

CaseSketch stadium() {
    PlaneSketch sketch = cells(4, 3);
    sketch.rectangle({0, 0}, {4, 3}, stroke(black, 3));
    for (int i = 0; i < 5; ++i) sketch.circle({1.5 + 0.05 * (i % 3), 1.45 + 0.05 * (i / 2)}, 0.06, stroke(blue, 1.2));
    sketch.arrow({-0.4, 1.2}, {4.3, 1.75}, stroke(orange, 2));
    sketch.words({1.5, 1.4}, "10 000 triangles", {.aside = {0, 30}, .anchor = Anchor::center});
    return case_sketch("All detail lies in one cell: each ray through it must test all of it.", sketch, {-0.5, -0.2},
                       {4.5, 3.2});
}

}  // namespace

CaseSketches case_sketches() { return {{"DDA-DRIFT", drift}, {"MAILBOX", mailbox}, {"STADIUM", stadium}}; }

}  // namespace raylab::grids
