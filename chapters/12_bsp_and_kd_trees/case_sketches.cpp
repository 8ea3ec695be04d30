#include "case_sketches.h"

namespace raylab::split {

namespace {

using namespace plane_ink;

CaseSketch split_plane() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {4, 3}, stroke(grey, 2));
    sketch.line({2, 0}, {2, 3}, stroke(grey, 2));
    sketch.line({2, 1.7}, {2, 2.6}, stroke(blue, 5));
    sketch.arrow({2, 0.2}, {2, 1.55}, stroke(vermilion));
    sketch.dot({2, 0.2}, 5);
    sketch.words({2, 0.8}, "*t* = 0 / 0", {.aside = {12, 4}, .color = vermilion});
    return case_sketch("The ray starts in the cutting plane and stays in it: it must visit both sides.", sketch,
                       {-0.3, -0.2}, {4.3, 3.2});
}

CaseSketch beyond_cell() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {4, 3}, stroke(grey, 2));
    sketch.line({2, 0}, {2, 3}, stroke(grey, 2));
    sketch.circle({2.7, 1.9}, 0.95, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.circle({2.25, 0.84}, 0.11, {.line = green, .fill = pale_green, .width = 2});
    sketch.arrow({-0.4, 0.3}, {3.9, 1.25}, stroke(orange, 2));
    sketch.dot({2.58, 0.96}, 5, vermilion);
    return case_sketch(
        "The large ball is in the list of the left cell, but hit in the right one, behind the small ball.", sketch,
        {-0.5, -0.2}, {4.3, 3.2});
}

CaseSketch painter() {
    PlaneSketch sketch;
    const PlaneStyle beams[] = {{.line = black, .fill = "#9cc9e6", .width = 1.5},
                                {.line = black, .fill = "#f3c26b", .width = 1.5},
                                {.line = black, .fill = "#8fd0b8", .width = 1.5}};
    sketch.polygon({{-0.3, -0.9}, {0.2, -1.2}, {1.75, 1.4}, {1.25, 1.7}}, beams[1]);
    sketch.polygon({{1.9, -0.3}, {1.9, 0.3}, {-1.9, 0.3}, {-1.9, -0.3}}, beams[0]);
    sketch.polygon({{-0.35, -1.05}, {0.25, -1.05}, {-1.3, 1.7}, {-1.8, 1.4}}, beams[2]);
    // The first beam again, where it covers the last.
    sketch.polygon({{-0.3, -0.9}, {0.2, -1.2}, {0.55, -0.62}, {0.05, -0.32}}, beams[1]);
    return case_sketch("Three beams in a ring, each before the next: no order of whole triangles paints them right.",
                       sketch, {-2.2, -1.4}, {2.2, 1.8});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"SPLIT-PLANE", split_plane}, {"BEYOND-CELL", beyond_cell}, {"PAINTER", painter}};
}

}  // namespace raylab::split
