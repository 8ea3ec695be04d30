#include "case_sketches.h"

namespace raylab::octrees {

namespace {

using namespace plane_ink;

// A square of side 4, cut in four, its upper right quarter again, and of that the lower left one once more.
PlaneSketch quarters() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {4, 4}, stroke(grey, 2));
    const auto cross = [&](double x, double y, double half) {
        sketch.line({x - half, y}, {x + half, y}, stroke(grey, 1.5));
        sketch.line({x, y - half}, {x, y + half}, stroke(grey, 1.5));
    };
    cross(2, 2, 2);
    cross(3, 3, 1);
    cross(2.5, 2.5, 0.5);
    return sketch;
}

CaseSketch cell_face() {
    PlaneSketch sketch = quarters();
    sketch.arrow({-0.6, 2}, {4.6, 2}, stroke(vermilion));
    sketch.line({2.2, 1.6}, {2.2, 2.4}, stroke(blue, 4));
    sketch.dot({2, 2}, 5);
    return case_sketch("The ray runs in the plane between cells and through their corners: whose cell is it in?",
                       sketch, {-0.8, -0.1}, {4.8, 4.1});
}

CaseSketch next_cell() {
    PlaneSketch sketch = quarters();
    sketch.circle({2.3, 2.25}, 0.09, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.arrow({-0.6, 2.05}, {4.6, 2.35}, stroke(orange, 2));
    sketch.dot({2, 2.2}, 5);
    sketch.dot({3.1, 2.263}, 5, vermilion);
    sketch.words({3.1, 2.26}, "half a cell on", {.aside = {-10, 26}, .color = vermilion});
    return case_sketch("The next cell is looked for half a cell along the ray: the small cell in between is passed by.",
                       sketch, {-0.8, -0.1}, {4.8, 4.1});
}

CaseSketch hit_outside() {
    PlaneSketch sketch = quarters();
    sketch.polygon({{0.3, 3.7}, {3.9, 0.7}, {3.9, 1.0}}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.circle({2.4, 1.52}, 0.15, {.line = green, .fill = pale_green, .width = 2});
    sketch.arrow({-0.6, 2.4}, {4.4, 1.0}, stroke(orange, 2));
    sketch.dot({3.1, 1.36}, 5, vermilion);
    return case_sketch(
        "The triangle is found in the first cell and hit in the last (dot): the ball between them is nearer.", sketch,
        {-0.8, -0.1}, {4.8, 4.1});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"CELL-FACE", cell_face}, {"NEXT-CELL", next_cell}, {"HIT-OUTSIDE", hit_outside}};
}

}  // namespace raylab::octrees
