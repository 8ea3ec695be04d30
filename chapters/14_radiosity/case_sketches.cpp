#include "case_sketches.h"

#include <cmath>

namespace raylab::cornell {

namespace {

using namespace plane_ink;

constexpr PlaneWords centred{.aside = {0, 22}, .anchor = Anchor::center};

// Two parallel patches from the side, the lower one emitting.
PlaneSketch two_patches(double half, double apart) {
    PlaneSketch sketch;
    sketch.line({-half, 0}, {half, 0}, stroke(orange, 4));
    sketch.line({-half, apart}, {half, apart}, stroke(blue, 4));
    return sketch;
}

CaseSketch hemicube_near() {
    PlaneSketch sketch = two_patches(1.2, 0.8);
    sketch.path({{-0.4, 0}, {-0.4, 0.4}, {0.4, 0.4}, {0.4, 0}}, stroke(green, 2));
    sketch.dot({0, 0}, 4);
    for (const double x : {-1.2, 1.2}) sketch.line({0, 0}, {x, 0.8}, stroke(grey, 1.5, dashed));
    return case_sketch("The hemicube asks from the middle alone; so near, the corners of the patch see something else.",
                       sketch, {-1.6, -0.5}, {1.6, 1.2});
}

CaseSketch hemicube_alias() {
    PlaneSketch sketch;
    for (int i = 0; i <= 5; ++i) {
        sketch.line({double(i), 0}, {double(i), 4}, stroke(light_grey, 1.5));
        if (i < 5) sketch.line({0, double(i)}, {5, double(i)}, stroke(light_grey, 1.5));
    }
    sketch.rectangle({1.55, 1.55}, {2.45, 2.45}, {.line = blue, .fill = pale_blue, .width = 2.5});
    for (const double x : {1.5, 2.5})
        for (const double y : {1.5, 2.5}) sketch.dot({x, y}, 5, vermilion);
    return case_sketch(
        "A square of a pixel's size misses all middles of pixels (dots), or covers one: nothing or too much.", sketch,
        {-0.3, -0.2}, {5.3, 4.2});
}

CaseSketch disk_near() {
    PlaneSketch sketch = two_patches(1.2, 0.5);
    sketch.line({-1.35, 0.5}, {1.35, 0.5}, stroke(vermilion, 2, dashed));
    sketch.dot({0, 0}, 4);
    sketch.words({0, 0.5}, "a disk of the same area",
                 {.aside = {0, -12}, .anchor = Anchor::center, .color = vermilion});
    return case_sketch(
        "The disk's formula takes the patch for far away: from near it is nearly as large as all that is seen.", sketch,
        {-1.6, -0.5}, {1.6, 1.2});
}

CaseSketch cancel() {
    PlaneSketch sketch;
    sketch.line({0, -0.1}, {0, 0.1}, stroke(orange, 4));
    sketch.line({4, -0.1}, {4, 0.1}, stroke(blue, 4));
    sketch.line({0.1, 0}, {3.9, 0}, stroke(grey, 1.5, dotted));
    sketch.words({2, 0}, "far", centred);
    return case_sketch(
        "The closed form is a sum of large terms; for small squares far apart, only rounding is left of it.", sketch,
        {-0.4, -1}, {4.4, 1});
}

CaseSketch touch() {
    PlaneSketch sketch;
    sketch.line({0, 0}, {2, 0}, stroke(orange, 4));
    sketch.line({0, 0}, {0, 1.6}, stroke(blue, 4));
    for (const double at : {0.15, 0.4, 0.9}) sketch.line({at, 0}, {0, at}, stroke(grey, 1.5));
    sketch.dot({0, 0}, 5, vermilion);
    return case_sketch(
        "Along the shared edge points come as near to each other as one likes: the density has no bound.", sketch,
        {-0.4, -0.4}, {2.3, 1.8});
}

CaseSketch blowup() {
    PlaneSketch sketch;
    sketch.rectangle({-1.2, -1.2}, {1.2, 1.2}, stroke(black, 4));
    PlanePoint at{-1.1, -0.6};
    const PlanePoint ways[] = {{0.4, 1.1}, {1.1, -0.2}, {-0.1, -1.1}, {-1.1, 0.5}};
    double width = 1;
    for (const auto& next : ways) {
        sketch.arrow(at, next, stroke(vermilion, width));
        width *= 1.7;
        at = next;
    }
    return case_sketch("Rows that sum to a little more than 1: each reflection makes light, and the sum explodes.",
                       sketch, {-1.9, -1.4}, {1.9, 1.4});
}

CaseSketch open_scene() {
    PlaneSketch sketch;
    sketch.path({{1.2, 1.1}, {-1.2, 1.1}, {-1.2, -1.1}, {1.2, -1.1}}, stroke(black, 4));
    sketch.arrow({-1.1, 0.4}, {2, 0.1}, stroke(orange));
    sketch.arrow({0.2, -1.05}, {1.9, -0.5}, stroke(orange));
    return case_sketch("Light leaves through the open front: rows sum to less than 1, and must not be lifted.", sketch,
                       {-1.5, -1.3}, {2.2, 1.3});
}

// A floor of patches from above.
PlaneSketch floor_of_patches() {
    PlaneSketch sketch;
    for (int i = 0; i <= 4; ++i) {
        sketch.line({double(i), 0}, {double(i), 3}, stroke(light_grey, 1.5));
        if (i < 4) sketch.line({0, double(i)}, {4, double(i)}, stroke(light_grey, 1.5));
    }
    return sketch;
}

CaseSketch light_leak() {
    PlaneSketch sketch;
    sketch.rectangle({1, 0}, {2, 3}, filled("#fbe3b5"));
    sketch.add(floor_of_patches().marks());
    sketch.line({1.5, 0}, {1.5, 3}, stroke(black, 5));
    sketch.light({0.5, 1.5});
    return case_sketch("A wall over the middle of patches: each is lit on one side, and bright on both.", sketch,
                       {-0.2, -0.2}, {4.2, 3.2});
}

CaseSketch shadow_mesh() {
    PlaneSketch sketch;
    sketch.polygon({{0, 0}, {2.6, 0}, {1.6, 3}, {0, 3}}, filled("#d0d0d6"));
    sketch.add(floor_of_patches().marks());
    sketch.line({2.6, 0}, {1.6, 3}, stroke(vermilion));
    return case_sketch("The shadow's edge (orange) crosses patches; what is constant on a patch makes stairs of it.",
                       sketch, {-0.2, -0.2}, {4.2, 3.2});
}

CaseSketch t_vertex() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {2, 2}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.rectangle({2, 0}, {3, 1}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.rectangle({2, 1}, {3, 2}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.dot({2, 1}, 6, vermilion);
    return case_sketch(
        "The small patches' vertex lies on the large one's side, where the mean of its ends is drawn: a crack.", sketch,
        {-0.3, -0.3}, {3.3, 2.3});
}

CaseSketch refine() {
    PlaneSketch sketch;
    sketch.line({0, 0}, {4, 0}, stroke(blue, 4));
    sketch.line({1, 2.6}, {3, 2.6}, stroke(orange, 4));
    sketch.line({1.2, 1.1}, {1.9, 1.1}, stroke(black, 4));
    sketch.arrow({2, 2.5}, {2, 0.1}, stroke(vermilion, 2));
    sketch.words({2, 1.6}, "one link", {.aside = {8, 0}, .color = vermilion});
    return case_sketch("One link for the whole floor passes the small blocker by: its shadow is never looked for.",
                       sketch, {-0.3, -0.3}, {4.3, 2.9});
}

CaseSketch hemicube_visibility() {
    PlaneSketch sketch = two_patches(1.2, 2);
    sketch.line({-0.25, 0.35}, {0.25, 0.35}, stroke(black, 4));
    for (const double x : {-0.25, 0.25}) sketch.line({0, 0}, {x * 5.7, 2}, stroke(vermilion, 1.5, dashed));
    for (const double x : {-1.2, 1.2}) sketch.line({x, 0}, {x * 0.6, 2}, stroke(green, 1.5));
    sketch.dot({0, 0}, 4);
    return case_sketch("A small screen hides all from the patch's middle, and little from the rest of the patch.",
                       sketch, {-1.7, -0.4}, {1.7, 2.4});
}

// A smooth hill of brightness, and the polygon through its values at the patches' corners.
CaseSketch mach_gouraud() {
    PlaneSketch sketch;
    const auto hill = [](double x) { return 2.2 / (1 + 1.2 * x * x); };
    std::vector<PlanePoint> smooth, corners;
    for (int i = -50; i <= 50; ++i) smooth.push_back({i * 0.05, hill(i * 0.05)});
    for (int i = -2; i <= 2; ++i) corners.push_back({i * 1.25, hill(i * 1.25)});
    sketch.line({-2.5, 0}, {2.5, 0}, stroke(grey, 1.5));
    sketch.path(smooth, stroke(green, 2));
    sketch.path(corners, stroke(vermilion, 2.5, dashed));
    for (const auto& corner : corners) {
        sketch.line({corner.x, 0}, corner, stroke(grey, 1, dotted));
        sketch.dot(corner, 4, vermilion);
    }
    return case_sketch(
        "Interpolated brightness bends where patches meet (dashed), and the eye sees each bend as a line.", sketch,
        {-2.7, -0.3}, {2.7, 2.5});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"HEMICUBE-NEAR", hemicube_near},
            {"HEMICUBE-ALIAS", hemicube_alias},
            {"DISK-NEAR", disk_near},
            {"FF-CANCEL", cancel},
            {"FF-TOUCH", touch},
            {"RADIOSITY-BLOWUP", blowup},
            {"OPEN-SCENE", open_scene},
            {"LIGHT-LEAK", light_leak},
            {"SHADOW-MESH", shadow_mesh},
            {"T-VERTEX", t_vertex},
            {"HIERARCHY-REFINE", refine},
            {"HEMICUBE-VISIBILITY", hemicube_visibility},
            {"MACH-GOURAUD", mach_gouraud}};
}

}  // namespace raylab::cornell
