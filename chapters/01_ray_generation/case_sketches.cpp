#include "case_sketches.h"

#include <cmath>

namespace raylab::ray_generation {

namespace {

using namespace plane_ink;

constexpr PlaneWords above{.aside = {0, -10}, .anchor = Anchor::center},
    below{.aside = {0, 22}, .anchor = Anchor::center};

CaseSketch up_parallel() {
    PlaneSketch sketch;
    sketch.arrow({0, 0}, {3, 1.2}, stroke(blue));
    sketch.arrow({0, 0}, {1.95, 0.9}, stroke(vermilion));
    sketch.dot({0, 0}, 5);
    sketch.words({3, 1.2}, "**f**", below);
    sketch.words({1.95, 0.9}, "**h**", above);
    sketch.words({0, 0}, "*C*", below);
    return case_sketch("The hint h lies along the view f: f × h is zero, and any direction may be called right.",
                       sketch, {-0.4, -0.6}, {3.4, 1.8});
}

CaseSketch fov_limits() {
    PlaneSketch sketch;
    sketch.line({1, -3}, {1, 3}, stroke(grey, 2));
    sketch.arrow({0, 0}, {1, 2.8}, stroke(blue));
    sketch.arrow({0, 0}, {1, -2.8}, stroke(blue));
    sketch.arrow({0, 0}, {2.2, 0}, stroke(black, 1.5));
    sketch.dot({0, 0}, 5);
    sketch.words({1, -2}, "the picture", {.aside = {10, 5}});
    sketch.words({2.2, 0}, "**f**", {.aside = {6, 5}});
    return case_sketch("As the field of view nears 180°, the top of the picture runs off to infinity.", sketch,
                       {-1, -2.4}, {3.4, 2.4});
}

CaseSketch eye_at_target() {
    PlaneSketch sketch;
    sketch.arrow({0, 0}, {-0.9, 0.9}, stroke(grey, 2, dashed));
    sketch.arrow({0, 0}, {1.2, 0.3}, stroke(grey, 2, dashed));
    sketch.arrow({0, 0}, {0.2, -1.1}, stroke(grey, 2, dashed));
    sketch.dot({0, 0}, 7, vermilion);
    sketch.words({0, 0}, "*C* = *T*", {.aside = {14, 26}});
    return case_sketch("Eye and target coincide: every direction leads from the one to the other.", sketch,
                       {-1.6, -1.3}, {1.6, 1.2});
}

CaseSketch camera_scale() {
    PlaneSketch sketch;
    for (const double size : {1.0, 2.0}) {
        sketch.line({size, -0.45 * size}, {size, 0.45 * size}, stroke(size == 1 ? blue : orange, 4));
        for (const double edge : {-0.45, 0.45}) sketch.line({0, 0}, {2.4, 2.4 * edge}, stroke(grey, 1.5));
    }
    sketch.dot({0, 0}, 5);
    sketch.words({1, -0.45}, "× 1", {.aside = {4, 24}, .color = blue});
    sketch.words({2, -0.9}, "× 2", {.aside = {-34, 8}, .color = "#8a5a00"});
    return case_sketch("Twice as large, the same rays: scaled by a power of two, not a bit may change.", sketch,
                       {-0.2, -1.1}, {2.6, 1.1});
}

CaseSketch far_camera() {
    PlaneSketch sketch;
    for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 4; ++y) sketch.dot({double(x), double(y)}, 3, grey);
    sketch.arrow({1.4, 1.4}, {3.7, 2.2}, stroke(blue));
    sketch.arrow({1, 1}, {3.3, 1.8}, stroke(vermilion));
    sketch.dot({1.4, 1.4}, 5, blue);
    sketch.dot({1, 1}, 5, vermilion);
    sketch.words({1.4, 1.4}, "eye", above);
    sketch.words({1, 1}, "its float", {.aside = {4, 24}, .color = vermilion});
    return case_sketch("10 000 km away floats are a metre apart (grey): the ray starts at the nearest one.", sketch,
                       {-0.4, -0.3}, {4.4, 3.3});
}

CaseSketch half_pixel() {
    PlaneSketch sketch;
    for (int x = 0; x <= 4; ++x) sketch.line({double(x), 0}, {double(x), 3}, stroke(light_grey, 1.5));
    for (int y = 0; y <= 3; ++y) sketch.line({0, double(y)}, {4, double(y)}, stroke(light_grey, 1.5));
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 3; ++y) {
            sketch.dot({x + 0.5, y + 0.5}, 4.5, blue);
            sketch.dot({double(x), y + 1.0}, 4.5, vermilion);
        }
    return case_sketch("Rays through corners (orange) in place of centres (blue) shift the picture by half a pixel.",
                       sketch, {-0.3, -0.2}, {4.3, 3.2});
}

CaseSketch pinhole() {
    PlaneSketch sketch;
    for (int i = 0; i < 11; ++i) {
        const double angle = (i + 0.5) * 2 * 3.14159265 / 11;
        sketch.arrow({0, 0}, {1.5 * std::cos(angle), 1.1 * std::sin(angle)}, stroke(orange, 1.8));
    }
    sketch.light({0, 0});
    sketch.dot({2.1, 0}, 4, blue);
    sketch.words({2.1, 0}, "eye", below);
    return case_sketch("However many rays leave the light, none goes exactly through a point.", sketch, {-1.6, -1.2},
                       {2.6, 1.2});
}

CaseSketch both_ways() {
    PlaneSketch sketch;
    sketch.line({0, 0}, {4, 0}, stroke(grey, 3));
    const PlanePoint light{0.6, 2}, hit{2, 0}, eye{3.6, 1.6};
    sketch.line(light, hit, stroke(orange));
    sketch.line(hit, eye, stroke(orange));
    sketch.arrow(light, {1.4, 0.857}, stroke(orange));
    sketch.arrow({3.4, 1.4}, {2.7, 0.7}, stroke(blue));
    sketch.light(light);
    sketch.dot(eye, 5, blue);
    sketch.words(eye, "eye", above);
    sketch.words(light, "light", {.aside = {14, -2}});
    return case_sketch("One path, from the light or from the eye: both must find the same brightness.", sketch,
                       {0, -0.3}, {4, 2.4});
}

CaseSketch sample_slope() {
    PlaneSketch sketch;
    sketch.arrow({0, 0}, {4, 0}, stroke(grey, 1.5));
    sketch.arrow({0, 0}, {0, 3}, stroke(grey, 1.5));
    sketch.line({0.3, 2.7}, {3.6, 1.05}, stroke(vermilion));
    sketch.line({0.3, 2.6}, {3.6, 0.125}, stroke(blue));
    sketch.words({3.6, 1.05}, "*N*^{-1/2}", {.aside = {-10, -14}, .anchor = Anchor::right, .color = vermilion});
    sketch.words({2.4, 1.0}, "*N*^{-3/4}", {.aside = {-14, 16}, .anchor = Anchor::right, .color = blue});
    sketch.words({0, 3}, "log error", {.aside = {10, 6}});
    sketch.words({4, 0}, "log *N*", {.aside = {0, -10}, .anchor = Anchor::right});
    return case_sketch("Random samples (orange) and jittered ones (blue): the slopes are measured.", sketch,
                       {-0.2, -0.2}, {4.2, 3.2});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"UP-PARALLEL", up_parallel},   {"FOV-LIMITS", fov_limits}, {"EYE-AT-TARGET", eye_at_target},
            {"CAMERA-SCALE", camera_scale}, {"FAR-CAMERA", far_camera}, {"HALF-PIXEL", half_pixel},
            {"PINHOLE", pinhole},           {"BOTH-WAYS", both_ways},   {"SAMPLE-SLOPE", sample_slope}};
}

}  // namespace raylab::ray_generation
