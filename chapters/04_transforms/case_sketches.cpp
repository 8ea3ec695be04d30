#include "case_sketches.h"

#include <cmath>
#include <vector>

namespace raylab::transforms {

namespace {

using namespace plane_ink;

constexpr PlaneStyle shape{.line = blue, .fill = pale_blue, .width = 2};

// An ellipse with half axes a and b, carried along x by `shear` times the height.
std::vector<PlanePoint> ellipse(PlanePoint center, double a, double b, double shear = 0) {
    std::vector<PlanePoint> points;
    for (int i = 0; i < 60; ++i) {
        const double angle = i * 2 * 3.14159265358979 / 60, y = b * std::sin(angle);
        points.push_back({center.x + a * std::cos(angle) + shear * y, center.y + y});
    }
    return points;
}

CaseSketch normal_shear() {
    // At the circle's point (0.6, 0.8), whose normal is that point, too, the shear x + 0.8 y makes (1.24, 0.8). The
    // inverse transpose of [1 0.8; 0 1] carries the normal to (0.6, 0.32).
    PlaneSketch sketch;
    sketch.polygon(ellipse({0, 0}, 1, 1, 0.8), shape);
    const PlanePoint at{1.24, 0.8};
    sketch.arrow(at, {at.x + 0.93, at.y + 0.6}, stroke(vermilion));
    sketch.arrow(at, {at.x + 0.88, at.y + 0.47}, stroke(blue));
    sketch.line({at.x - 0.47, at.y + 0.88}, {at.x + 0.47, at.y - 0.88}, stroke(grey, 1.5, dashed));
    return case_sketch("Carried like a point (orange) a normal leans; by the inverse transpose (blue) it does not.",
                       sketch, {-1.5, -1.2}, {2.6, 1.7});
}

CaseSketch mirror() {
    PlaneSketch sketch;
    sketch.polygon(ellipse({-1.3, 0}, 1, 1), shape);
    sketch.polygon(ellipse({1.3, 0}, 1, 1), shape);
    sketch.line({0, -1.4}, {0, 1.4}, stroke(grey, 2, dashed));
    sketch.arrow({-2.0, 0.714}, {-2.5, 1.224}, stroke(blue));
    sketch.arrow({2.0, 0.714}, {2.5, 1.224}, stroke(blue));
    sketch.arrow({2.0, 0.714}, {1.5, 0.204}, stroke(vermilion));
    return case_sketch("A mirror's determinant is negative: without its sign every normal points inward (orange).",
                       sketch, {-2.7, -1.5}, {2.7, 1.5});
}

CaseSketch unit_again() {
    PlaneSketch sketch;
    sketch.polygon(ellipse({0, 0}, 1.9, 0.8), shape);
    sketch.arrow({-2.9, 0.3}, {2.9, 0.3}, stroke(orange, 2));
    const double hit = -1.9 * std::sqrt(1 - 0.09 / 0.64);
    sketch.dot({hit, 0.3}, 5, blue);
    sketch.dot({-2.9 + (hit + 2.9) / 1.9, 0.3}, 5, vermilion);
    sketch.words({hit, 0.3}, "*t*", {.aside = {8, -8}, .color = blue});
    sketch.words({-2.9 + (hit + 2.9) / 1.9, 0.3}, "wrong *t*",
                 {.aside = {0, 26}, .anchor = Anchor::center, .color = vermilion});
    return case_sketch("A direction that is made unit again in object space measures another t there.", sketch,
                       {-3.1, -1.2}, {3.1, 1.3});
}

CaseSketch far_instance() {
    PlaneSketch sketch;
    sketch.arrow({-2.4, -1.2}, {-1.6, -1.2}, stroke(grey, 2));
    sketch.arrow({-2.4, -1.2}, {-2.4, -0.4}, stroke(grey, 2));
    sketch.line({-2.2, -1.0}, {1.0, 0.6}, stroke(grey, 1.5, dotted));
    sketch.polygon(ellipse({1.6, 0.8}, 0.5, 0.5), shape);
    sketch.arrow({0.4, 1.3}, {2.6, 1.3}, stroke(orange, 2));
    sketch.words({-0.5, -0.2}, "100 km", {.aside = {14, 14}});
    return case_sketch("A ball far from the origin: the inverse map subtracts what is nearly equal.", sketch,
                       {-2.6, -1.4}, {2.8, 1.6});
}

CaseSketch flat_instance() {
    PlaneSketch sketch;
    sketch.polygon(ellipse({0, 0}, 2, 0.03), {.line = blue, .fill = blue, .width = 3});
    sketch.arrow({-2.4, 0.9}, {1.6, -0.5}, stroke(orange, 2));
    sketch.arrow({1.2, 1.3}, {1.2, 0.1}, stroke(grey, 2));
    sketch.words({1.2, 1.3}, "1/10 000", {.aside = {-8, 10}, .anchor = Anchor::right});
    return case_sketch("A ball pressed flat: its quadric's numbers differ by the square of 10 000.", sketch,
                       {-2.6, -1.1}, {2.6, 1.5});
}

CaseSketch tiny_instance() {
    PlaneSketch sketch;
    sketch.polygon(ellipse({0, 0}, 0.9, 0.9), shape);
    sketch.arrow({-2.2, 0.4}, {2.2, 0.4}, stroke(orange, 2));
    sketch.line({-0.9, -1.15}, {0.9, -1.15}, stroke(grey, 2));
    sketch.words({0, -1.15}, "10^{-14} m", {.aside = {0, 24}, .anchor = Anchor::center});
    return case_sketch("A determinant is a volume: of 1e-42 cubic metres, which no float holds in full.", sketch,
                       {-2.4, -1.7}, {2.4, 1.2});
}

CaseSketch singular() {
    PlaneSketch sketch;
    sketch.polygon({{-2.4, -0.5}, {-1.2, -0.5}, {-1.2, 0.7}, {-2.4, 0.7}}, shape);
    sketch.arrow({-0.9, 0.1}, {0.1, 0.1}, stroke(black, 2));
    sketch.line({0.4, -0.7}, {2.4, 0.9}, stroke(blue, 4));
    return case_sketch("A map that presses a square to a line has no inverse; so near to one, rounding decides.",
                       sketch, {-2.6, -1}, {2.6, 1.2});
}

}  // namespace

CaseSketches case_sketches() {
    return {{"NORMAL-SHEAR", normal_shear},
            {"MIRROR", mirror},
            {"UNIT-AGAIN", unit_again},
            {"FAR-INSTANCE", far_instance},
            {"FLAT-INSTANCE", flat_instance},
            {"TINY-INSTANCE", tiny_instance},
            {"SINGULAR", singular}};
}

}  // namespace raylab::transforms
