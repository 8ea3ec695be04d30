#include "case_examples.h"

#include "raylab/report/case_drawings.h"
#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace raylab::grids {

namespace {

using namespace plane_ink;

using Place = std::array<std::int64_t, 3>;

Place place_of(CellNumber cell, const CubeOfCells& cube) {
    const auto n = static_cast<CellNumber>(cube.n);
    return {static_cast<std::int64_t>(cell % n), static_cast<std::int64_t>(cell / n % n),
            static_cast<std::int64_t>(cell / (n * n))};
}

std::size_t axis_between(const Place& from, const Place& to) {
    std::size_t axis = 0;
    while (axis < 2 && from[axis] == to[axis]) ++axis;
    return axis;
}

// How much of the ray lies in a cell, in cells.
double way_in(const Ray& ray, const Place& cell, int n) {
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[static_cast<int>(axis)], direction = ray.direction[static_cast<int>(axis)];
        const double a = (static_cast<double>(cell[axis]) / n - origin) / direction,
                     b = (static_cast<double>(cell[axis] + 1) / n - origin) / direction;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return (leave - enter) * glm::length(convert<double>(ray.direction)) * n;
}

}  // namespace

CaseExample example_of(const LostCell& lost, const CubeOfCells& cube) {
    const Place here = place_of(lost.truth[lost.lost], cube);
    const auto before = axis_between(place_of(lost.truth[lost.lost - 1], cube), here);
    const auto behind = axis_between(here, place_of(lost.truth[lost.lost + 1], cube));
    const auto u = before, v = behind != before ? behind : (before + 1) % 3;
    // In cells, from the lost one's middle.
    const auto middle = [&](const Place& cell) {
        return PlanePoint{static_cast<double>(cell[u] - here[u]), static_cast<double>(cell[v] - here[v])};
    };
    const auto on_ray = [&](double t) {
        const auto at = [&](std::size_t axis) {
            const int i = static_cast<int>(axis);
            return (double{lost.ray.origin[i]} + t * lost.ray.direction[i]) * cube.n - static_cast<double>(here[axis]) -
                   0.5;
        };
        return PlanePoint{at(u), at(v)};
    };
    PlaneSketch sketch;
    sketch.rectangle({-0.5, -0.5}, {0.5, 0.5}, filled("#fbd9c5"));
    for (double line = -2.5; line < 3; ++line) {
        sketch.line({line, -2.5}, {line, 2.5}, stroke(light_grey, 1.5));
        sketch.line({-2.5, line}, {2.5, line}, stroke(light_grey, 1.5));
    }
    // Where the ray is nearest to the cell, and two and a half cells to either side.
    const PlanePoint origin = on_ray(0), further = on_ray(1);
    const PlanePoint way{further.x - origin.x, further.y - origin.y};
    const double length = std::hypot(way.x, way.y), t = -(origin.x * way.x + origin.y * way.y) / (length * length);
    sketch.arrow(on_ray(t - 2.5 / length), on_ray(t + 2.5 / length), stroke(blue));
    std::vector<PlanePoint> walked;
    for (const CellNumber cell : lost.walked) {
        const Place place = place_of(cell, cube);
        const auto is_near = [&](std::size_t axis) { return std::abs(place[axis] - here[axis]) <= 2; };
        if (is_near(0) && is_near(1) && is_near(2)) walked.push_back(middle(place));
    }
    sketch.path(walked, stroke(vermilion, 2, dashed));
    auto drawing = case_drawing_around({{-2.5, -2.5}, {2.5, 2.5}});
    drawing.marks = sketch.marks();
    drawing.notes = {fmt::format("The ray cuts {:.2g} off this cell;", way_in(lost.ray, here, cube.n)),
                     "the walk (dashed) goes around it."};
    return {in_words(lost.ray) + fmt::format(", cell [{}, {}, {}] of {} a side", here[0], here[1], here[2], cube.n),
            drawing};
}

}  // namespace raylab::grids
