#include "drawings.h"

#include "plane_tree.h"

#include "raylab/accelerator/sorted_primitives.h"
#include "raylab/accelerator/split_tree/sah_cost.h"
#include "raylab/report/plane/plane_sketch.h"

#include <algorithm>
#include <map>
#include <set>

namespace raylab::split {

namespace {

PlanePoint middle(const std::vector<PlanePoint>& corners) {
    PlanePoint sum{0, 0};
    for (const PlanePoint corner : corners) sum = {sum.x + corner.x, sum.y + corner.y};
    const double n = static_cast<double>(corners.size());
    return {sum.x / n, sum.y / n};
}

// The tree with its root above, its leaves at equal distances.
class TreePicture {
public:
    TreePicture(PlaneSketch& sketch, const std::map<const PlaneTree*, std::size_t>& numbers, PlanePoint low,
                PlanePoint high)
        : sketch_(sketch), numbers_(numbers), low_(low), high_(high) {}

    // Draws what is below the node and returns where the node stands.
    PlanePoint draw(const PlaneTree& node, int depth) {
        const double y = high_.y - depth * (high_.y - low_.y) / 3;
        if (node.walls.empty()) {
            const double step = (high_.x - low_.x) / static_cast<double>(numbers_.size() - 1);
            const PlanePoint at{low_.x + step * static_cast<double>(leaves_++), y};
            sketch_.rectangle({at.x - 0.45, at.y - 0.45}, {at.x + 0.45, at.y + 0.45},
                              {.line = plane_ink::black, .fill = plane_ink::pale_orange, .width = 1.5});
            words(at, std::to_string(numbers_.at(&node)));
            return at;
        }
        const PlanePoint behind = draw(*node.behind, depth + 1), before = draw(*node.before, depth + 1);
        const PlanePoint at{(behind.x + before.x) / 2, y};
        edge(at, behind, "behind", Anchor::right);
        edge(at, before, "before", Anchor::left);
        sketch_.circle(at, 0.55, {.line = plane_ink::blue, .fill = "#ffffff", .width = 2});
        words(at, node.walls.front().name);
        return at;
    }

private:
    void edge(PlanePoint from, PlanePoint to, const std::string& side, Anchor anchor) {
        sketch_.line({from.x, from.y - 0.55}, {to.x, to.y + 0.5}, {.line = plane_ink::grey, .width = 1.5});
        if (from.y > high_.y - 0.1)
            sketch_.words({(from.x + to.x) / 2, (from.y + to.y) / 2}, side,
                          {{anchor == Anchor::right ? -10.0 : 10.0, -4}, anchor, plane_ink::grey});
    }
    void words(PlanePoint at, const std::string& text) { sketch_.words(at, text, {{0, 6}, Anchor::center}); }

    PlaneSketch& sketch_;
    const std::map<const PlaneTree*, std::size_t>& numbers_;
    PlanePoint low_, high_;
    std::size_t leaves_ = 0;
};

// The line that divides a region: the side that both of its halves share.
void draw_divisions(PlaneSketch& sketch, const PlaneTree& tree) {
    if (tree.walls.empty()) return;
    sketch.polygon(tree.behind->region, {.line = plane_ink::blue, .width = 1.5, .dash = PlaneStyle::Dash::dashed});
    draw_divisions(sketch, *tree.behind);
    draw_divisions(sketch, *tree.before);
}

void draw_walls(PlaneSketch& sketch, const PlaneTree& tree) {
    if (tree.walls.empty()) return;
    for (const Wall& wall : tree.walls) {
        sketch.line(wall.from, wall.to, {.line = plane_ink::black, .width = 5});
        sketch.words(middle({wall.from, wall.to}), wall.name, {{12, -8}, Anchor::center, plane_ink::blue, 13});
    }
    draw_walls(sketch, *tree.behind);
    draw_walls(sketch, *tree.before);
}

// One of the three cases: a cell about the part begin..end of a ray, and a plane at t.
void draw_case(PlaneSketch& sketch, double left, double plane, const std::string& title, const std::string& visited) {
    constexpr double begin = 1.2, end = 3.8;
    const auto fill = [&](double from, double to, const char* color) {
        if (from < to) sketch.rectangle({left + from, 0.6}, {left + to, 2.6}, {.line = "", .fill = color});
    };
    fill(begin, std::min(end, plane), plane_ink::pale_orange);
    fill(std::max(begin, plane), end, plane_ink::pale_blue);
    sketch.rectangle({left + begin, 0.6}, {left + end, 2.6}, {.line = plane_ink::grey, .width = 1.5});
    sketch.line({left + plane, 0.2}, {left + plane, 3}, {.line = plane_ink::blue, .width = 2.5});
    sketch.arrow({left + 0.1, 1.6}, {left + 4.9, 1.6}, {.line = plane_ink::vermilion, .width = 2.5});
    const PlaneWords below{{0, 20}, Anchor::center};
    sketch.dot({left + begin, 1.6}, 4);
    sketch.dot({left + end, 1.6}, 4);
    sketch.words({left + begin, 0.6}, "begin", below);
    sketch.words({left + end, 0.6}, "end", below);
    sketch.words({left + plane, 3}, "*t*", {{0, -6}, Anchor::center, plane_ink::blue, 13});
    sketch.words({left + 2.5, 4}, title, {{0, 0}, Anchor::center});
    sketch.words({left + 2.5, -0.6}, visited, {{0, 0}, Anchor::center});
}

}  // namespace

PlaneDrawing draw_plane_tree() {
    const std::vector<Wall> walls{
        {"A", {2.5, 3.2}, {9.2, 5.4}}, {"B", {6.6, 8.8}, {4.2, 5.8}}, {"C", {8.6, 1}, {6.2, 7}}};
    const PlaneTree tree = plane_tree({{0, 0}, {12, 0}, {12, 10}, {0, 10}}, walls);
    const PlanePoint eye{1.1, 8.9};
    std::map<const PlaneTree*, std::size_t> numbers;
    for (const PlaneTree* leaf : front_to_back(tree, eye)) numbers.emplace(leaf, numbers.size() + 1);
    PlaneSketch sketch;
    draw_divisions(sketch, tree);
    sketch.rectangle({0, 0}, {12, 10}, {.line = plane_ink::grey, .width = 1.5});
    draw_walls(sketch, tree);
    for (const PlaneTree* leaf : front_to_back(tree, eye))  // the map's own order is that of addresses
        sketch.words(middle(leaf->region), std::to_string(numbers.at(leaf)),
                     {{0, 6}, Anchor::center, plane_ink::vermilion, 15});
    sketch.dot(eye, 7, plane_ink::vermilion);
    sketch.words(eye, "eye", {{12, 5}, Anchor::left, plane_ink::vermilion, 13});
    TreePicture(sketch, numbers, {14.2, 1.2}, {23.4, 9}).draw(tree, 0);
    return {
        .title = "", .low = {-0.2, -0.2}, .high = {24.2, 10.2}, .width = 960, .height = 410, .marks = sketch.marks()};
}

PlaneDrawing draw_three_cases() {
    PlaneSketch sketch;
    draw_case(sketch, 0, 4.5, "the plane is behind the cell", "near half only, [begin, end]");
    draw_case(sketch, 5.4, 2.5, "the plane is in the cell", "near [begin, t], far waits: [t, end]");
    draw_case(sketch, 10.8, 0.6, "the plane is before the cell", "far half only, [begin, end]");
    return {.title = "", .low = {-0.1, -1}, .high = {15.9, 4.4}, .width = 960, .height = 325, .marks = sketch.marks()};
}

CurveChart sweep_chart(const Scene& scene, const SahCosts& costs) {
    const SortedPrimitives sorted(scene);
    Box cell;
    for (const Box& box : sorted.boxes) cell = unite(cell, box);
    const Vec3d size = convert<double>(cell.max) - convert<double>(cell.min);
    CurveChart chart{.title = "The cheapest cut is where something begins or ends",
                     .x_label = "place of the plane, as a share of the side it cuts",
                     .y_label = "expected cost of a ray",
                     .curves = {}};
    for (int axis = 0; axis < 3; ++axis) {
        Curve curve{.name = std::string("across ") + "xyz"[axis], .x = {}, .y = {}};
        std::set<double> places;
        for (const Box& box : sorted.boxes) places.insert({double{box.min[axis]}, double{box.max[axis]}});
        for (const double at : places) {
            SahCut cut{size, axis, at - cell.min[axis], 0, 0, costs.visit, costs.test, costs.empty_bonus};
            // On either side of the place: what ends here is no longer above, what begins here is not yet below.
            for (const bool after : {false, true}) {
                cut.below = cut.above = 0;
                for (const Box& box : sorted.boxes) {
                    cut.below += box.min[axis] < at || (after && box.min[axis] <= at) ? 1 : 0;
                    cut.above += box.max[axis] > at || (!after && box.max[axis] >= at) ? 1 : 0;
                }
                curve.x.push_back(cut.place / size[axis]);
                curve.y.push_back(sah_cost(cut));
            }
        }
        chart.curves.push_back(curve);
    }
    const double uncut = costs.test * static_cast<double>(sorted.boxes.size());
    chart.curves.push_back({.name = "not cut", .x = {0, 1}, .y = {uncut, uncut}});
    return chart;
}

}  // namespace raylab::split
