#include "drawings.h"

#include "raylab/report/plane/plane_sketch.h"

#include <string>

namespace raylab::coherence {

namespace {

const PlaneStyle ray_style{.line = plane_ink::vermilion, .width = 1.5};

void draw_box(PlaneSketch& sketch, PlanePoint low, PlanePoint high, const char* fill, const std::string& words) {
    sketch.rectangle(low, high, {.line = plane_ink::black, .fill = fill, .width = 2});
    sketch.words({(low.x + high.x) / 2, high.y}, words, {{0, -8}, Anchor::center});
}

// Left: where a ray goes is the place where it leaves a square about its origin.
void draw_ray_point(PlaneSketch& sketch) {
    const PlanePoint origin{2.2, 2.5};
    constexpr double half = 1.5, u = 0.4;
    sketch.rectangle({origin.x - half, origin.y - half}, {origin.x + half, origin.y + half},
                     {.line = plane_ink::grey, .width = 1.5});
    sketch.line({origin.x + half, origin.y - half}, {origin.x + half, origin.y + half},
                {.line = plane_ink::blue, .width = 4});
    sketch.arrow(origin, {origin.x + 2.6, origin.y + 2.6 * u}, {.line = plane_ink::vermilion, .width = 2.5});
    sketch.dot(origin, 5);
    sketch.words(origin, "origin", {{0, 22}, Anchor::center});
    sketch.dot({origin.x + half, origin.y + half * u}, 5, plane_ink::blue);
    sketch.words({origin.x + half, origin.y + half * u}, "*u* = 0.4", {{9, 22}, Anchor::left, plane_ink::blue});
    sketch.words({origin.x + half, origin.y + half}, "1", {{9, 5}, Anchor::left, plane_ink::blue});
    sketch.words({origin.x + half, origin.y - half}, "-1", {{9, 5}, Anchor::left, plane_ink::blue});
    sketch.words({2.6, 4.9}, "one ray", {{0, 0}, Anchor::center});
}

// Right: all rays with origins in a box and directions in a range.
void draw_cell(PlaneSketch& sketch) {
    const PlanePoint low{6.4, 1}, high{7.2, 1.8};
    constexpr double down = 0.05, up = 0.45, right = 14;
    sketch.polygon({{low.x, low.y},
                    {high.x, low.y},
                    {right, low.y + (right - high.x) * down},
                    {right, high.y + (right - low.x) * up},
                    {low.x, high.y}},
                   {.line = "", .fill = plane_ink::pale_orange});
    draw_box(sketch, {8.6, 1.7}, {9.3, 2.3}, plane_ink::pale_green, "A");
    draw_box(sketch, {11.4, 2.9}, {12.3, 3.6}, plane_ink::pale_green, "B");
    draw_box(sketch, {10.2, 0.1}, {11.1, 0.7}, plane_ink::pale_grey, "C");
    sketch.rectangle(low, high, {.line = plane_ink::blue, .fill = plane_ink::pale_blue, .width = 2});
    for (const auto& [from, slope] :
         {std::pair{PlanePoint{6.6, 1.2}, 0.12}, {PlanePoint{7.0, 1.6}, 0.3}, {PlanePoint{6.8, 1.1}, 0.42}}) {
        sketch.arrow(from, {13.4, from.y + (13.4 - from.x) * slope}, ray_style);
        sketch.dot(from, 3.5);
    }
    sketch.words({(low.x + high.x) / 2, low.y}, "origins", {{0, 22}, Anchor::center, plane_ink::blue});
    sketch.words({8.6, 4.9}, "a cell of rays, and its list: A, B", {{0, 0}, Anchor::center});
}

}  // namespace

PlaneDrawing draw_packet() {
    PlaneSketch sketch;
    draw_box(sketch, {4, 1}, {5, 2}, plane_ink::pale_green, "all");
    draw_box(sketch, {7, 2}, {8, 3}, plane_ink::pale_orange, "some");
    draw_box(sketch, {4, 2.5}, {5, 3.5}, plane_ink::pale_grey, "none");
    constexpr int rays = 8;
    constexpr double lowest = 0.2 / 0.98, highest = 0.28 / 0.96, length = 9.4;
    for (int i = 0; i < rays; ++i) {
        const double slope = lowest + (highest - lowest) * i / (rays - 1);
        sketch.arrow({0, 0}, {length, length * slope}, ray_style);
    }
    sketch.dot({0, 0}, 6);
    sketch.words({0, 0}, "eye", {{0, 24}, Anchor::center});
    return {.title = "", .low = {-0.4, -0.6}, .high = {9.8, 4}, .width = 780, .height = 350, .marks = sketch.marks()};
}

PlaneDrawing draw_ray_cells() {
    PlaneSketch sketch;
    draw_ray_point(sketch);
    draw_cell(sketch);
    return {.title = "", .low = {0.4, 0}, .high = {14.2, 5.3}, .width = 960, .height = 370, .marks = sketch.marks()};
}

}  // namespace raylab::coherence
