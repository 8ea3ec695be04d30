#include "walk_drawings.h"

#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace raylab::grids {

namespace {

using namespace plane_ink;

// A grid of squares of side 1 with its corner at (0, 0), and a ray that comes from its left.
constexpr int columns = 5, rows = 4;
constexpr PlanePoint origin{-1, 0.4}, direction{1, 0.45};
constexpr std::array<PlanePoint, 2> plank{{{1.2, 1.05}, {4.4, 3.0}}};
constexpr PlanePoint ball{2.78, 2.22};
constexpr double ball_radius = 0.18;

PlanePoint at(double t) { return {origin.x + t * direction.x, origin.y + t * direction.y}; }

struct Square {
    int x, y;
};

// The cells on the ray's way with their first and last t, in order.
struct Passed {
    Square cell;
    double enter, next_x, next_y;

    double leave() const { return std::min(next_x, next_y); }
};

std::vector<Passed> cells_passed() {
    const auto t_of_x = [](int plane) { return (plane - origin.x) / direction.x; };
    const auto t_of_y = [](int plane) { return (plane - origin.y) / direction.y; };
    std::vector<Passed> all;
    Square cell{0, static_cast<int>(std::floor(at(t_of_x(0)).y))};
    double enter = t_of_x(0);
    while (cell.x < columns && cell.y < rows) {
        const Passed here{cell, enter, t_of_x(cell.x + 1), t_of_y(cell.y + 1)};
        all.push_back(here);
        (here.next_x < here.next_y ? cell.x : cell.y) += 1;
        enter = here.leave();
    }
    return all;
}

double t_of_plank() {
    const PlanePoint along{plank[1].x - plank[0].x, plank[1].y - plank[0].y},
        way{plank[0].x - origin.x, plank[0].y - origin.y};
    return (way.x * along.y - way.y * along.x) / (direction.x * along.y - direction.y * along.x);
}

double t_of_ball() {
    const PlanePoint way{ball.x - origin.x, ball.y - origin.y};
    const double a = direction.x * direction.x + direction.y * direction.y,
                 b = way.x * direction.x + way.y * direction.y,
                 c = way.x * way.x + way.y * way.y - ball_radius * ball_radius;
    return (b - std::sqrt(b * b - a * c)) / a;
}

// Whether the plank passes the open cell: the part of it between the cell's planes of x overlaps in y.
bool lists_plank(Square cell) {
    const double slope = (plank[1].y - plank[0].y) / (plank[1].x - plank[0].x);
    const double left = std::max(plank[0].x, 1.0 * cell.x), right = std::min(plank[1].x, cell.x + 1.0);
    const auto y = [&](double x) { return plank[0].y + slope * (x - plank[0].x); };
    return left < right && y(right) > cell.y && y(left) < cell.y + 1;
}

bool lists_ball(Square cell) { return cell.x == std::floor(ball.x) && cell.y == std::floor(ball.y); }

void fill_cell(PlaneSketch& sketch, Square cell, const std::string& color) {
    sketch.rectangle({1.0 * cell.x, 1.0 * cell.y}, {cell.x + 1.0, cell.y + 1.0}, {.line = "", .fill = color});
}

void add_grid(PlaneSketch& sketch) {
    for (int x = 0; x <= columns; ++x)
        sketch.line({1.0 * x, 0}, {1.0 * x, 1.0 * rows}, {.line = "#b8b8c0", .width = 1.2});
    for (int y = 0; y <= rows; ++y)
        sketch.line({0, 1.0 * y}, {1.0 * columns, 1.0 * y}, {.line = "#b8b8c0", .width = 1.2});
}

enum class Tested { no, yes };

void add_things(PlaneSketch& sketch, Tested is_plank_tested, Tested is_ball_tested) {
    const bool bold_plank = is_plank_tested == Tested::yes, bold_ball = is_ball_tested == Tested::yes;
    sketch.line(plank[0], plank[1], {.line = bold_plank ? black : grey, .width = bold_plank ? 6.0 : 4.0});
    sketch.circle(ball, ball_radius,
                  {.line = bold_ball ? black : grey, .fill = "#ffffff", .width = bold_ball ? 4.0 : 2.0});
    sketch.words(plank[1], "plank", {.aside = {0, -8}, .anchor = Anchor::center, .height = 10.5});
    sketch.words({ball.x, ball.y + ball_radius}, "ball", {.aside = {0, -7}, .anchor = Anchor::center, .height = 10.5});
}

std::string bold_if(const std::string& words, bool is_bold) { return is_bold ? "**" + words + "**" : words; }

}  // namespace

PlaneDrawing draw_crossings() {
    constexpr double end = 7;
    PlaneSketch sketch;
    const auto axis = [&](double y, const std::string& words) {
        sketch.arrow({0.8, y}, {end + 0.3, y}, {.line = grey, .width = 1.5});
        sketch.words({0.75, y}, words, {.aside = {-8, 5}, .anchor = Anchor::right});
    };
    axis(2, "planes of *x*");
    axis(1, "planes of *y*");
    axis(0, "both: the next cell");
    const auto crossing = [&](double y, double t, const std::string& name, const char* color) {
        sketch.line({t, y - 0.14}, {t, y + 0.14}, {.line = color, .width = 3});
        sketch.words({t, y}, fmt::format("{:.4g}", t), {.aside = {0, 28}, .anchor = Anchor::center, .height = 11});
        sketch.line({t, y - 0.36}, {t, 0.14}, {.line = light_grey, .dash = dotted});
        sketch.line({t, -0.14}, {t, 0.14}, {.line = color, .width = 3});
        sketch.words({t, 0}, name, {.aside = {0, -16}, .anchor = Anchor::center, .color = color});
    };
    for (int x = 1; (x - origin.x) / direction.x < end; ++x) crossing(2, (x - origin.x) / direction.x, "*x*", blue);
    for (int y = 1; (y - origin.y) / direction.y < end; ++y)
        crossing(1, (y - origin.y) / direction.y, "*y*", vermilion);
    sketch.words({end + 0.3, 0}, "*t*", {.aside = {8, 5}});
    sketch.arrow({3, 2.35}, {4, 2.35}, {.line = blue, .width = 1.5});
    sketch.words({3.5, 2.35}, fmt::format("side / |*D*_{{x}}| = {:.4g}", 1 / direction.x),
                 {.aside = {0, -8}, .anchor = Anchor::center, .color = blue, .height = 11});
    const double first = (1 - origin.y) / direction.y, step = 1 / direction.y;
    sketch.arrow({first, 1.35}, {first + step, 1.35}, {.line = vermilion, .width = 1.5});
    sketch.words({first + step / 2, 1.35}, fmt::format("side / |*D*_{{y}}| = {:.4g}", step),
                 {.aside = {0, -8}, .anchor = Anchor::center, .color = vermilion, .height = 11});
    return {.low = {-1.1, -0.35}, .high = {end + 0.5, 2.75}, .width = 960, .height = 370, .marks = sketch.marks()};
}

PlaneDrawing draw_walk_step(int step) {
    const auto cells = cells_passed();
    const Passed& here = cells.at(static_cast<std::size_t>(step - 1));
    PlaneSketch sketch;
    for (int before = 1; before < step; ++before)
        fill_cell(sketch, cells[static_cast<std::size_t>(before - 1)].cell, "#f3ead8");
    fill_cell(sketch, here.cell, "#f9cf7c");
    add_grid(sketch);
    const bool has_plank = lists_plank(here.cell), has_ball = lists_ball(here.cell);
    const bool knows_plank = std::ranges::any_of(cells.begin(), cells.begin() + step,
                                                 [](const Passed& cell) { return lists_plank(cell.cell); });
    add_things(sketch, has_plank ? Tested::yes : Tested::no, has_ball ? Tested::yes : Tested::no);
    const double nearest = has_ball ? t_of_ball() : knows_plank ? t_of_plank() : 0;
    const bool ends = nearest > 0 && nearest <= here.leave();
    sketch.arrow(origin, at(ends ? nearest : here.leave()), {.line = blue, .width = 2.5});
    if (nearest > 0) {
        if (!ends) sketch.line(at(here.leave()), at(nearest), {.line = blue, .width = 1.5, .dash = dashed});
        sketch.dot(at(nearest), 5.5, vermilion);
    }
    for (int before = 1; before <= step; ++before) {
        const Square cell = cells[static_cast<std::size_t>(before - 1)].cell;
        sketch.words({1.0 * cell.x, 1.0 * cell.y}, std::to_string(before),
                     {.aside = {7, -8}, .color = grey, .height = 11, .halo = ""});
    }
    const std::string listed = has_plank && has_ball ? "plank and ball" : has_plank ? "the plank" : "nothing";
    const std::string ahead = bold_if(fmt::format("x at {:.3f}", here.next_x), here.next_x < here.next_y) + ", " +
                              bold_if(fmt::format("y at {:.3f}", here.next_y), here.next_y < here.next_x);
    const std::string found = nearest == 0 ? "no hit"
                              : ends       ? fmt::format("hit at {:.3f}, in the cell: end", nearest)
                                           : fmt::format("hit at {:.3f}, beyond the cell", nearest);
    const auto below = [&](const std::string& words, double pixels) {
        sketch.words({-1, 0}, words, {.aside = {0, pixels}, .height = 10.5});
    };
    below(fmt::format("{}: cell ({}, {}) lists {}.", step, here.cell.x, here.cell.y, listed), 22);
    below("Planes ahead: " + ahead + ".", 42);
    below("So far: " + found + ".", 62);
    return {.low = {-1.1, -1.1}, .high = {5.2, 4.05}, .width = 400, .height = 340, .marks = sketch.marks()};
}

PlaneDrawing draw_hit_beyond() {
    PlaneSketch sketch;
    const auto cells = cells_passed();
    for (int x = 0; x < columns; ++x)
        for (int y = 0; y < rows; ++y)
            if (lists_plank({x, y})) fill_cell(sketch, {x, y}, pale_blue);
    add_grid(sketch);
    add_things(sketch, Tested::yes, Tested::no);
    sketch.arrow(origin, at(5), {.line = blue, .width = 2.2});
    const auto first = std::ranges::find_if(cells, [](const Passed& cell) { return lists_plank(cell.cell); });
    const auto mark = [&](double t, const char* color, const std::string& words, Point2 aside,
                          Anchor anchor = Anchor::left) {
        sketch.dot(at(t), 5.5, color);
        sketch.words(at(t), words, {.aside = aside, .anchor = anchor, .color = color});
    };
    mark(first->enter, black, "the plank is tested here ...", {-6, 52});
    mark(t_of_plank(), vermilion, "... and hit here", {10, 26});
    mark(t_of_ball(), green, "the ball is hit before it", {-18, -12}, Anchor::right);
    return {.low = {-1.1, -0.1}, .high = {5.2, 4.1}, .width = 640, .height = 440, .marks = sketch.marks()};
}

}  // namespace raylab::grids
