#include "drawings.h"

#include "raylab/report/plane/plane_sketch.h"
#include "raylab/sampling/sampler.h"

#include <vector>

namespace raylab::spread {

using namespace plane_ink;

PlaneDrawing draw_patterns(std::uint64_t seed) {
    constexpr int count = 64, columns = 4, cells = 8;
    constexpr double step_x = 1.2, step_y = 1.38;
    PlaneSketch sketch;
    const std::vector<std::string> names = sampler_names();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double x0 = step_x * static_cast<double>(i % columns), y0 = -step_y * static_cast<double>(i / columns);
        sketch.rectangle({x0, y0}, {x0 + 1, y0 + 1}, {.line = grey, .fill = "#ffffff", .width = 1.5});
        for (int line = 1; line < cells; ++line) {
            const double at = line / static_cast<double>(cells);
            sketch.line({x0 + at, y0}, {x0 + at, y0 + 1}, stroke(light_grey, 0.7));
            sketch.line({x0, y0 + at}, {x0 + 1, y0 + at}, stroke(light_grey, 0.7));
        }
        const Sampler sampler{sampler_kind(names[i]), count, seed};
        for (int k = 0; k < count; ++k) {
            const auto [x, y] = pair(sampler, {.pixel = 0, .index = k}, 0);
            sketch.dot({x0 + x, y0 + y}, 3.4, blue);
        }
        sketch.words({x0 + 0.5, y0 + 1}, names[i], {.aside = {0, -9}, .anchor = Anchor::center, .height = 13});
    }
    return sketch.drawing({-0.1, -1.48}, {4.7, 1.2}, 1200, 670);
}

namespace {

// Two rims of the lens, through one point of the plane in focus, to a plane farther on.
void add_cone(PlaneSketch& sketch, PlanePoint focus, double radius, double beyond, const std::string& color) {
    for (const double rim : {-radius, radius}) {
        const double slope = (focus.y - rim) / focus.x;
        sketch.line({0, rim}, {beyond, rim + slope * beyond}, stroke(color, 2));
    }
}

}  // namespace

PlaneDrawing draw_thin_lens() {
    constexpr double radius = 0.9, focus = 6, far = 9, near = 3;
    PlaneSketch sketch;
    sketch.line({0, 0}, {far + 0.6, 0}, stroke(light_grey, 1.5, dashed));
    for (const double x : {near, focus, far})
        sketch.line({x, -1.35}, {x, 1.75}, x == focus ? stroke(green, 3) : stroke(grey, 1.6, dashed));
    add_cone(sketch, {focus, 0}, radius, far, blue);
    const double spread_far = radius * (far - focus) / focus, spread_near = radius * (focus - near) / focus;
    sketch.line({far, -spread_far}, {far, spread_far}, stroke(vermilion, 6));
    sketch.line({near, -spread_near}, {near, spread_near}, stroke(vermilion, 6));
    sketch.line({0, -radius}, {0, radius}, stroke(black, 6));
    sketch.dot({focus, 0}, 6, green);
    sketch.arrow({0, 0.5}, {1.8, 0.35}, stroke(black, 2.5));
    const auto centred = [](const std::string& color, Point2 aside) {
        return PlaneWords{.aside = aside, .anchor = Anchor::center, .color = color, .height = 14};
    };
    sketch.words({0, radius}, "lens", centred(black, {0, -12}));
    sketch.words({0, 0.5}, "*L*", centred(black, {-16, 5}));
    sketch.words({focus, 1.75}, "in focus", centred(green, {0, -10}));
    sketch.words({near, 1.75}, "too near", centred(grey, {0, -10}));
    sketch.words({far, 1.75}, "too far", centred(grey, {0, -10}));
    sketch.words({focus, 0}, "*F*", centred(green, {18, 32}));
    sketch.words({far, -spread_far}, "*c*", centred(vermilion, {18, 6}));
    sketch.words({near, -spread_near}, "*c*", centred(vermilion, {-16, 16}));
    return sketch.drawing({-0.8, -1.5}, {9.9, 2.1}, 960, 330);
}

}  // namespace raylab::spread
