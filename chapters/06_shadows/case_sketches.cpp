#include "case_sketches.h"

#include <cmath>

namespace raylab::shadows {

namespace {

using namespace plane_ink;

constexpr PlaneStyle shape{.line = blue, .fill = pale_blue, .width = 2};

// A floor as an eye sees it that rounds: the point found lies `height` over it.
PlaneSketch floor_and_light(PlanePoint start) {
    PlaneSketch sketch;
    sketch.rectangle({-2.2, -0.7}, {2.2, 0}, {.line = "", .fill = pale_blue});
    sketch.line({-2.2, 0}, {2.2, 0}, stroke(blue, 3));
    sketch.light({1.6, 1.9});
    sketch.dot(start, 5);
    return sketch;
}

CaseSketch acne() {
    PlaneSketch sketch = floor_and_light({-0.9, -0.25});
    sketch.arrow({-0.9, -0.25}, {-0.7, -0.05}, stroke(vermilion));
    sketch.line({-0.7, 0}, {1.5, 1.8}, stroke(grey, 1.5, dotted));
    sketch.dot({-0.62, 0}, 5, vermilion);
    sketch.words({-0.9, -0.25}, "the rounded hit", {.aside = {10, 14}});
    return case_sketch("The rounded hit lies below the floor: its shadow ray hits the floor itself.", sketch,
                       {-2.2, -0.7}, {2.2, 2.2});
}

CaseSketch contact() {
    PlaneSketch sketch = floor_and_light({-0.3, 0});
    sketch.line({-0.1, 0}, {-0.1, 0.35}, stroke(blue, 4));
    sketch.dot({-0.3, 0.75}, 5, vermilion);
    sketch.line({-0.3, 0}, {-0.3, 0.7}, stroke(grey, 1.5, dotted));
    sketch.arrow({-0.3, 0.75}, {1.35, 1.75}, stroke(vermilion));
    sketch.arrow({-0.3, 0.02}, {-0.13, 0.12}, stroke(green, 2));
    sketch.words({-0.3, 0.4}, "offset", {.aside = {-10, 4}, .anchor = Anchor::right});
    return case_sketch("An offset that is too large lifts the start over what stands on the floor: its shadow is lost.",
                       sketch, {-2.2, -0.7}, {2.2, 2.2});
}

CaseSketch far_eye() {
    PlaneSketch sketch = floor_and_light({-1.4, -0.192});
    sketch.line({2.2, 0.5}, {-0.4, 0}, stroke(orange, 1.5));
    sketch.arrow({-0.4, 0}, {-1.4, -0.192}, stroke(orange, 1.5));
    sketch.words({2.2, 0.5}, "from an eye, kilometres away", {.aside = {-4, -14}, .anchor = Anchor::right});
    sketch.dot({-0.4, 0}, 4, grey);
    return case_sketch("O + t d is off by what t is off: the point lies deep below the floor that was hit.", sketch,
                       {-2.2, -0.7}, {2.2, 2.2});
}

CaseSketch skip_alone() {
    PlaneSketch sketch;
    sketch.polygon({{-2, -1}, {-0.6, 0.5}, {0.6, 0.5}, {2, -1}}, {.line = "", .fill = pale_blue});
    sketch.path({{-2, -1}, {-0.6, 0.5}, {0.6, 0.5}, {2, -1}}, stroke(blue, 3));
    sketch.dot({-0.55, 0.45}, 5);
    sketch.arrow({-0.55, 0.45}, {-0.9, 0.28}, stroke(vermilion));
    sketch.line({-0.9, 0.28}, {-2, -0.2}, stroke(grey, 1.5, dotted));
    sketch.light({-2, 1.2});
    sketch.words({0, 0.5}, "skipped", {.aside = {0, -10}, .anchor = Anchor::center});
    sketch.words({-0.95, 0.25}, "hit", {.aside = {-14, -8}, .anchor = Anchor::right, .color = vermilion});
    return case_sketch("The facet that was hit is skipped, its neighbour beside the rounded point is not.", sketch,
                       {-2.3, -1}, {2.3, 1.5});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"ACNE", acne}, {"CONTACT", contact}, {"FAR-EYE", far_eye}, {"SKIP-ALONE", skip_alone}};
}

}  // namespace raylab::shadows
