#include "case_sketches.h"

namespace raylab {

namespace {

using namespace plane_ink;

constexpr PlaneStyle left{.line = blue, .fill = pale_blue, .width = 2},
    right{.line = green, .fill = pale_green, .width = 2};

// Two triangles with a common edge, as a ray sees them.
PlaneSketch two_triangles() {
    PlaneSketch sketch;
    sketch.polygon({{-2, 0.2}, {0.2, -1.2}, {-0.2, 1.2}}, left);
    sketch.polygon({{0.2, -1.2}, {2, 0}, {-0.2, 1.2}}, right);
    return sketch;
}

CaseSketch fma_switch() {
    PlaneSketch sketch = two_triangles();
    sketch.dot({0, 0}, 5, vermilion);
    sketch.words({-0.2, 0.3}, "*ab* − *cd*", {.aside = {-14, 0}, .anchor = Anchor::right});
    sketch.words({0.2, 0.3}, "*cd* − *ab*", {.aside = {14, 0}});
    return case_sketch("One product rounded and one not: the edge's number is no longer the same from both sides.",
                       sketch, {-2.2, -1.4}, {2.2, 1.4});
}

CaseSketch double_input() {
    PlaneSketch sketch = two_triangles();
    sketch.circle({0, 0}, 0.5, stroke(grey, 1.5, dashed));
    sketch.dot({0.05, 0}, 4, vermilion);
    sketch.words({0.36, 0.36}, "× 2^{53}", {.aside = {8, -6}});
    return case_sketch("With 53 bits in ray and vertices the edge lies between doubles, as it lay between floats.",
                       sketch, {-2.2, -1.4}, {2.2, 1.4});
}

CaseSketch epick_ray() {
    PlaneSketch sketch;
    for (int x = 0; x < 6; ++x)
        for (int y = 0; y < 4; ++y) sketch.dot({0.8 * x, 0.8 * y}, 2.5, grey);
    sketch.arrow({0, 0}, {4, 1.5}, stroke(blue));
    sketch.arrow({0, 0}, {3.9, 1.95}, stroke(vermilion));
    sketch.dot({1.6, 0.6}, 4.5, blue);
    sketch.dot({1.6, 0.8}, 4.5, vermilion);
    sketch.words({0, 0}, "*o*", {.aside = {-4, 22}, .anchor = Anchor::center});
    return case_sketch("A ray kept as two points: the second one is rounded (orange), and it is another ray.", sketch,
                       {-0.5, -0.6}, {4.4, 2.6});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"FMA-SWITCH", fma_switch}, {"DOUBLE-INPUT", double_input}, {"EPICK-RAY", epick_ray}};
}

}  // namespace raylab
