#include "case_sketches.h"

#include <cmath>
#include <numbers>

namespace raylab::spread {

namespace {

using namespace plane_ink;
using std::numbers::pi;

CaseSketch area_pdf() {
    PlaneSketch sketch = floor_with_point();
    sketch.line({-0.5, 2}, {0.5, 2}, stroke(orange, 5));
    for (const double x : {-0.4, 0.0, 0.4}) sketch.line({x, 2}, {0, 0}, stroke(grey, 1.5, dashed));
    sketch.words({0.6, 2}, "1 m", {.aside = {6, 5}});
    return case_sketch(
        "One point a square metre of the light is not one a steradian: cosine and distance stand between them.", sketch,
        {-2, -0.4}, {2, 2.3});
}

CaseSketch horizon() {
    PlaneSketch sketch = floor_with_point();
    sketch.line({1.4, -0.8}, {1.4, 0.8}, stroke(orange, 5));
    sketch.line({0, 0}, {1.4, 0.5}, stroke(blue, 2));
    sketch.line({0, 0}, {1.4, -0.5}, stroke(vermilion, 2, dashed));
    return case_sketch("Half of the light stands below the point's horizon: what is drawn there brings nothing.",
                       sketch, {-2, -1.1}, {2, 1.2});
}

CaseSketch tiny() {
    PlaneSketch sketch = floor_with_point();
    sketch.line({-1.4, 0.22}, {1.4, 0.22}, stroke(orange, 5));
    for (const double x : {-1.2, -0.1, 0.9}) sketch.line({x, 0.22}, {0, 0}, stroke(grey, 1.5));
    return case_sketch(
        "The light is a centimetre away: points of it count as one over the squared distance, most of them nothing.",
        sketch, {-2, -0.8}, {2, 1.2});
}

CaseSketch glossy() {
    PlaneSketch sketch = floor_with_point();
    sketch.arrow({-1.5, 1.5}, {-0.05, 0.05}, stroke(blue));
    std::vector<PlanePoint> lobe;
    for (int i = -12; i <= 12; ++i) {
        const double angle = pi / 4 + i * 0.05, length = 1.5 * std::pow(std::cos(i * 0.1), 4);
        lobe.push_back({length * std::cos(angle), length * std::sin(angle)});
    }
    lobe.push_back({0, 0});
    sketch.polygon(lobe, {.line = blue, .fill = pale_blue, .width = 1.5});
    sketch.line({1.2, 1.7}, {1.7, 1.2}, stroke(orange, 5));
    return case_sketch(
        "By the lobe (blue) or by the light (orange)? A wide lobe misses the light, a wide light the lobe.", sketch,
        {-2, -0.4}, {2, 1.9});
}

CaseSketch firefly() {
    PlaneSketch sketch = floor_with_point();
    sketch.line({1.5, 0.3}, {1.5, 1.6}, stroke(blue, 4));
    sketch.line({0, 0}, {1.5, 0.9}, stroke(vermilion));
    sketch.line({1.5, 0.9}, {0.35, 1.6}, stroke(vermilion));
    sketch.line({0.15, 1.6}, {0.45, 1.75}, stroke(orange, 5));
    sketch.words({1.5, 1.6}, "mirror", {.aside = {0, -8}, .anchor = Anchor::center, .color = blue});
    return case_sketch(
        "The light comes by the mirror: no shadow ray finds it, a random ray rarely, and then far too bright.", sketch,
        {-2, -0.4}, {2.2, 2.1});
}

CaseSketch disk_sqrt() {
    PlaneSketch sketch;
    for (const double x : {-1.15, 1.15}) sketch.circle({x, 0}, 1, stroke(grey, 2));
    for (int i = 0; i < 60; ++i) {
        const double angle = 2.399963 * i, share = (i + 0.5) / 60;
        sketch.dot({-1.15 + share * std::cos(angle), share * std::sin(angle)}, 3, vermilion);
        sketch.dot({1.15 + std::sqrt(share) * std::cos(angle), std::sqrt(share) * std::sin(angle)}, 3, blue);
    }
    return case_sketch(
        "A radius that is itself even crowds the middle (orange); its root fills the lens evenly (blue).", sketch,
        {-2.3, -1.3}, {2.3, 1.3});
}

CaseSketch slope_and_bias() {
    PlaneSketch sketch;
    sketch.arrow({0, 0}, {4, 0}, stroke(grey, 1.5));
    sketch.arrow({0, 0}, {0, 3}, stroke(grey, 1.5));
    sketch.line({0.3, 2.6}, {3.6, 0.4}, stroke(blue));
    sketch.path({{0.3, 2.7}, {1.6, 1.85}, {2.3, 1.6}, {3.6, 1.5}}, stroke(vermilion));
    sketch.words({4, 0}, "log *N*", {.aside = {0, -10}, .anchor = Anchor::right});
    sketch.words({0, 3}, "log error", {.aside = {10, 6}});
    return case_sketch(
        "With a wrong map the error falls at first, too, and then stays (orange): a slope proves little.", sketch,
        {-0.2, -0.2}, {4.2, 3.2});
}

CaseSketch twice() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {2.4, 2.4}, stroke(grey, 2));
    for (int i = 0; i < 12; ++i) sketch.dot({0.2 * i + 0.1, 0.2 * i + 0.1}, 4, vermilion);
    sketch.words({1.2, 0}, "where in the pixel", {.aside = {0, 22}, .anchor = Anchor::center});
    sketch.words({0, 1.2}, "in the lens", {.aside = {-8, 4}, .anchor = Anchor::right});
    return case_sketch(
        "One number for two decisions: all samples lie on a diagonal, the rest of the square is never asked.", sketch,
        {-1.6, -0.6}, {2.8, 2.6});
}

CaseSketch padding() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {2.4, 2.4}, stroke(grey, 2));
    for (int i = 0; i < 29; ++i)
        for (const double shift : {0.0, 1.2})
            sketch.dot({2.4 * (i + 0.5) / 29, std::fmod(2.4 * (i + 0.5) / 29 + shift, 2.4)}, 2.5, vermilion);
    return case_sketch("Two late dimensions of a sequence: each is even by itself, together they leave stripes.",
                       sketch, {-0.9, -0.2}, {3.3, 2.6});
}

CaseSketch strobe() {
    PlaneSketch sketch;
    for (int i = 0; i < 4; ++i)
        sketch.circle({0.4 + 0.95 * i, 1}, 0.4, {.line = blue, .fill = i == 3 ? pale_blue : "", .width = 2});
    sketch.arrow({0.4, 1.8}, {3.25, 1.8}, stroke(grey, 2));
    return case_sketch("The same four moments in every pixel: not one blurred ball but four sharp ones.", sketch,
                       {-0.3, 0.2}, {4, 2.2});
}

CaseSketch focus_on_eye() {
    PlaneSketch sketch;
    sketch.line({0, -1}, {0, 1}, stroke(blue, 5));
    sketch.line({0.02, -1.3}, {0.02, 1.3}, stroke(vermilion, 2, dashed));
    sketch.arrow({0, 0.6}, {0, -0.9}, stroke(grey, 2));
    sketch.words({0, 1}, "lens", {.aside = {-12, 0}, .anchor = Anchor::right, .color = blue});
    sketch.words({0, -1}, "in focus", {.aside = {12, 0}, .color = vermilion});
    return case_sketch("The plane in focus lies in the lens: rays would run inside it, so the camera is refused.",
                       sketch, {-2, -1.4}, {2, 1.4});
}

CaseSketch adaptive_bias() {
    PlaneSketch sketch;
    sketch.arrow({0, 0}, {4, 0}, stroke(grey, 1.5));
    sketch.line({0, 1.2}, {4, 1.2}, stroke(grey, 1.5, dashed));
    sketch.path({{0, 0.2}, {0.5, 0.2}}, stroke(vermilion));
    sketch.path({{0, 2.0}, {0.5, 1.6}, {1, 1.9}, {1.6, 0.9}, {2.4, 1.4}, {3.2, 1.1}, {4, 1.2}}, stroke(blue));
    sketch.dot({0.5, 0.2}, 6, vermilion);
    sketch.words({0.5, 0.2}, "stops: all tails", {.aside = {12, 5}, .color = vermilion});
    sketch.words({4, 1.2}, "truth", {.aside = {0, -8}, .anchor = Anchor::right});
    return case_sketch("Who stops when the tosses agree stops too early, and always on the same side.", sketch,
                       {-0.2, -0.3}, {4.2, 2.3});
}

CaseSketch thin_penumbra() {
    PlaneSketch sketch;
    sketch.rectangle({0, 0}, {2.4, 2.4}, {.line = grey, .fill = "#55555c", .width = 2});
    sketch.rectangle({2.28, 0}, {2.4, 2.4}, filled("#ffd93b"));
    for (const PlanePoint at : {PlanePoint{0.5, 0.7}, {1.7, 0.4}, {0.8, 1.9}, {1.9, 1.6}}) sketch.dot(at, 5, "#ffffff");
    return case_sketch("A twentieth of the pixel is lit; four samples in the dark agree, and nobody asks on.", sketch,
                       {-0.9, -0.2}, {3.3, 2.6});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"LIGHT-AREA-PDF", area_pdf},
            {"HORIZON-LIGHT", horizon},
            {"TINY-LIGHT", tiny},
            {"GLOSSY-MIS", glossy},
            {"FIREFLY", firefly},
            {"DISK-SQRT", disk_sqrt},
            {"SLOPE-AND-BIAS", slope_and_bias},
            {"SAME-NUMBER-TWICE", twice},
            {"PADDING", padding},
            {"STROBE", strobe},
            {"FOCUS-ON-EYE", focus_on_eye},
            {"ADAPTIVE-BIAS", adaptive_bias},
            {"THIN-PENUMBRA", thin_penumbra}};
}

}  // namespace raylab::spread
