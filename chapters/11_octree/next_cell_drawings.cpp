#include "next_cell_drawings.h"

#include "block_tree.h"

#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace raylab::octrees {

namespace {

constexpr int side = 16;
constexpr const char *ray_ink = plane_ink::vermilion, *light_blue = "#cfe6f5", *light_orange = "#fbdcc4",
                     *light_yellow = "#fdf3d3";

// What the cells were cut for.
const std::vector<PlanePoint> things{{6.4, 5.5}, {9.5, 3.4}, {13.4, 9.6}, {14.5, 13.5}, {2.4, 13.5}};

void draw_square(PlaneSketch& sketch, const BlockTree& cell, const PlaneStyle& style) {
    const double x = cell.x, y = cell.y, s = cell.side;
    sketch.rectangle({x, y}, {x + s, y + s}, style);
}

void draw_cells(PlaneSketch& sketch, const BlockTree& cell) {
    for (const BlockTree& child : cell.cells) draw_cells(sketch, child);
    if (cell.cells.empty()) draw_square(sketch, cell, {.line = plane_ink::grey, .width = 1.2});
}

void draw_things(PlaneSketch& sketch) {
    for (const PlanePoint thing : things) sketch.dot(thing, 6, "#555560");
}

PlanePoint middle(PlanePoint a, PlanePoint b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

void draw_ray(PlaneSketch& sketch, const std::vector<LeafOnWay>& way) {
    sketch.arrow(way.front().in, way.back().out, {.line = ray_ink, .width = 2.5});
}

// The last number stands beyond the arrow, whose head hides a small leaf, and the one before below the ray.
void draw_numbers(PlaneSketch& sketch, const std::vector<LeafOnWay>& way) {
    for (std::size_t i = 0; i + 2 < way.size(); ++i)
        sketch.words(middle(way[i].in, way[i].out), std::to_string(i + 1), {{-9, -7}, Anchor::center});
    const LeafOnWay& before = way[way.size() - 2];
    sketch.words(middle(before.in, before.out), std::to_string(way.size() - 1), {{9, 21}, Anchor::center});
    sketch.words(way.back().out, std::to_string(way.size()), {{6, 0}});
}

// The tree of the cells beside the square: each node above its children, leaves at equal distances.
class TreeLayout {
public:
    TreeLayout(const BlockTree& root, PlanePoint low, PlanePoint high) : low_(low), high_(high) {
        depth_ = place(root, 0);
        for (auto& [cell, at] : places_) at = scaled(at);
    }
    PlanePoint at(const BlockTree& cell) const { return places_.at(&cell); }

private:
    // Leaves are counted from the left; returns the depth below the cell.
    int place(const BlockTree& cell, int depth) {
        int deepest = depth;
        for (const BlockTree& child : cell.cells) deepest = std::max(deepest, place(child, depth + 1));
        const double x = cell.cells.empty()
                             ? static_cast<double>(leaves_++)
                             : (places_.at(&cell.cells.front()).x + places_.at(&cell.cells.back()).x) / 2;
        places_[&cell] = {x, static_cast<double>(depth)};
        return deepest;
    }
    PlanePoint scaled(PlanePoint at) const {
        return {low_.x + (high_.x - low_.x) * at.x / (leaves_ - 1),
                high_.y - (high_.y - low_.y) * at.y / std::max(1, depth_)};
    }

    PlanePoint low_, high_;
    int leaves_ = 0, depth_ = 0;
    std::map<const BlockTree*, PlanePoint> places_;
};

void draw_tree(PlaneSketch& sketch, const BlockTree& cell, const TreeLayout& layout) {
    for (const BlockTree& child : cell.cells) {
        sketch.line(layout.at(cell), layout.at(child), {.line = "#b5b5bd", .width = 1.3});
        draw_tree(sketch, child, layout);
    }
    const bool leaf = cell.cells.empty();
    sketch.dot(layout.at(cell), leaf ? 4 : 6, leaf ? plane_ink::grey : "#555560");
}

// The step with the most moves up and down that does not go up to the root.
std::size_t longest_step(const std::vector<LeafOnWay>& way) {
    std::size_t best = 0, moves = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const std::size_t common = shared(way[i], way[i + 1]);
        const std::size_t count = way[i].path.size() + way[i + 1].path.size() - 2 * common;
        if (common > 1 && count > moves) {
            moves = count;
            best = i;
        }
    }
    return best;
}

}  // namespace

PlaneDrawing draw_up_and_down() {
    const BlockTree tree = block_tree(side, things, {1, 1, 1, 1});
    const auto way = way_through(tree, {0.4, 2.2}, {1, 0.63});
    const std::size_t step = longest_step(way);
    const LeafOnWay &old = way[step], &next = way[step + 1];
    const std::size_t common = shared(old, next);
    const BlockTree& both = *old.path[common - 1];
    PlaneSketch sketch;
    draw_square(sketch, both, {.line = "", .fill = light_yellow});
    draw_square(sketch, old.leaf(), {.line = "", .fill = light_orange});
    draw_square(sketch, next.leaf(), {.line = "", .fill = light_blue});
    draw_cells(sketch, tree);
    draw_square(sketch, both, {.line = plane_ink::black, .width = 3});
    draw_things(sketch);
    draw_ray(sketch, way);
    draw_numbers(sketch, way);

    const TreeLayout layout(tree, {18, 1.6}, {43.5, 14.8});
    draw_tree(sketch, tree, layout);
    for (std::size_t i = 0; i < way.size(); ++i)
        sketch.words(layout.at(way[i].leaf()), std::to_string(i + 1), {{i == step ? 10.0 : 0.0, 24}, Anchor::center});
    sketch.dot(layout.at(both), 9);
    for (std::size_t i = old.path.size() - 1; i >= common; --i)
        sketch.arrow(layout.at(*old.path[i]), layout.at(*old.path[i - 1]), {.line = plane_ink::vermilion, .width = 3});
    for (std::size_t i = common; i < next.path.size(); ++i)
        sketch.arrow(layout.at(*next.path[i - 1]), layout.at(*next.path[i]), {.line = plane_ink::blue, .width = 3});
    sketch.words({17.6, 16.3},
                 fmt::format("leaf {}: up to the cell that holds both, down to leaf {}", step + 1, step + 2));
    return {.title = "", .low = {-0.4, -1.2}, .high = {44, 17}, .width = 960, .height = 400, .marks = sketch.marks()};
}

PlaneDrawing draw_blocks() {
    const BlockTree tree = block_tree(side, things, {1, 2});
    const auto way = way_through(tree, {0.4, 2.2}, {1, 0.63});
    PlaneSketch sketch;
    for (const LeafOnWay& at : way) draw_square(sketch, at.leaf(), {.line = "", .fill = light_yellow});
    draw_cells(sketch, tree);
    for (const BlockTree& block : tree.cells) draw_square(sketch, block, {.line = plane_ink::black, .width = 3});
    draw_things(sketch);
    draw_ray(sketch, way);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const bool leaves = shared(way[i], way[i + 1]) + 1 < way[i].path.size();
        const bool to_x = way[i].across == 0;
        const std::string color = leaves ? plane_ink::black : "#a64600";
        sketch.dot(way[i].out, leaves ? 6 : 4, leaves ? plane_ink::black : ray_ink);
        sketch.words(way[i].out, std::string(leaves ? "up, " : "") + (to_x ? "+x" : "+y"),
                     to_x ? PlaneWords{{7, 18}, Anchor::left, color} : PlaneWords{{-7, -9}, Anchor::right, color});
    }
    return {
        .title = "", .low = {-0.4, -0.4}, .high = {16.4, 16.4}, .width = 600, .height = 600, .marks = sketch.marks()};
}

}  // namespace raylab::octrees
