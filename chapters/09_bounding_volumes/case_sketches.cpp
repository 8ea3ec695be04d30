#include "case_sketches.h"

namespace raylab::volumes {

namespace {

using namespace plane_ink;

CaseSketch slab_nan() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {2, 1.2}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.line({-1.4, 1.2}, {3.2, 1.2}, stroke(grey, 1.5, dashed));
    sketch.arrow({-1.4, 1.2}, {3.2, 1.2}, stroke(vermilion));
    sketch.words({-1.4, 1.2}, "(high − *o*) / *d* = 0 / 0", {.aside = {0, -12}, .color = vermilion});
    return case_sketch("The ray runs in the plane of a face: its t there is no number.", sketch, {-1.5, -0.5},
                       {3.3, 2});
}

CaseSketch slab_pad() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {2, 1.4}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.rectangle({-0.12, -0.12}, {2.12, 1.52}, stroke(green, 1.5, dashed));
    sketch.arrow({1.2, 2.2}, {2.8, 0.6}, stroke(vermilion));
    sketch.dot({2, 1.4}, 5);
    return case_sketch(
        "Through a corner: both t are equal, and rounding says that one comes too late. Padded (dashed), none is "
        "lost.",
        sketch, {-0.6, -0.4}, {3, 2.3});
}

CaseSketch void_area() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {2.4, 1.8}, stroke(blue, 2));
    sketch.polygon({{0, 0.12}, {0.12, 0}, {2.4, 1.68}, {2.28, 1.8}}, {.line = black, .fill = light_grey, .width = 2});
    sketch.arrow({-0.5, 1.4}, {2.9, 1.75}, stroke(orange, 2));
    sketch.arrow({-0.5, 0.5}, {2.9, 0.2}, stroke(vermilion, 2));
    sketch.arrow({-0.5, 1.7}, {1.4, -0.3}, stroke(orange, 2));
    return case_sketch(
        "Most rays that hit the box of a slanted rod pass the rod: they are counted, and (3) says how many.", sketch,
        {-0.6, -0.4}, {3, 2});
}

}  // namespace

CaseSketches case_sketches() { return {{"SLAB-NAN", slab_nan}, {"SLAB-PAD", slab_pad}, {"VOID-AREA", void_area}}; }

}  // namespace raylab::volumes
