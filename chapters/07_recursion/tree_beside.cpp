#include "section.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace raylab::recursion {

namespace {

constexpr double capitals = 13;                        // the height of a capital, in pixels
constexpr double column = 1.6, row = 1.55, top = 5.6;  // of the tree, in metres of the section beside it

// Places nodes: leaves in columns from left to right, a parent above the middle of its children.
class Layout {
public:
    Layout(const RayTree& tree, double left) : below_(children(tree)), left_(left) { place(0, 0); }

    PlanePoint at(std::size_t node) const { return at_.at(node); }
    bool is_leaf(std::size_t node) const { return below_[node].empty(); }

private:
    double place(std::size_t node, int level) {
        double x = 0;
        if (below_[node].empty()) {
            x = left_ + column * leaves_++;
        } else {
            double first = 0, last = 0;
            for (const std::size_t child : below_[node]) {
                last = place(child, level + 1);
                if (child == below_[node].front()) first = last;
            }
            x = (first + last) / 2;
        }
        at_[node] = {x, top - row * level};
        return x;
    }

    std::vector<std::vector<std::size_t>> below_;
    double left_;
    int leaves_ = 0;
    std::map<std::size_t, PlanePoint> at_;
};

std::string letter_of(RayKind kind) {
    switch (kind) {
        case RayKind::eye:
            return "eye";
        case RayKind::reflected:
            return "R";
        case RayKind::transmitted:
            return "T";
        case RayKind::shadow:
            return "L";
        case RayKind::diffuse:
            return "D";
    }
    return "";
}

void add_edge(PlaneSketch& sketch, const RayTree& tree, const Layout& layout, std::size_t i) {
    const RayNode& node = tree.nodes[i];
    const PlanePoint from = layout.at(node.parent), to = layout.at(i);
    sketch.path({from, to}, style_of(node.kind));
    const double share = node.throughput / tree.nodes[node.parent].throughput;
    sketch.words({std::lerp(from.x, to.x, 0.6), std::lerp(from.y, to.y, 0.6)},
                 node.kind == RayKind::shadow ? "L" : fmt::format("{} {:.2g}", letter_of(node.kind), share),
                 {.aside = {0, capitals / 2},
                  .anchor = Anchor::center,
                  .color = style_of(node.kind).line,
                  .height = capitals - 1});
}

void add_node(PlaneSketch& sketch, const Scene& scene, const RayTree& tree, const Layout& layout, std::size_t i) {
    const RayNode& node = tree.nodes[i];
    const PlanePoint at = layout.at(i);
    const auto text = [&](const std::string& words, Anchor anchor, Point2 aside, const std::string& color) {
        sketch.words(at, words, {.aside = aside, .anchor = anchor, .color = color, .height = capitals, .halo = {}});
    };
    if (was_cast(node)) {
        sketch.dot(at, 15, style_of(node.kind).line);
        text(fmt::format("**{}**", i + 1), Anchor::center, {0, capitals / 2}, "#ffffff");
    } else {
        sketch.dot(at, 15, "#ffffff");
        text("**×**", Anchor::center, {0, capitals / 2}, "#b00000");
    }
    const std::string word = word_for(scene, node);
    if (node.kind == RayKind::shadow) {
        text(word, Anchor::center, {0, 36}, "#222222");
    } else if (layout.is_leaf(i)) {
        text(word, Anchor::center, {0, 36}, "#222222");
        text(fmt::format("{:.2g}", node.throughput), Anchor::center, {0, 57}, "#222222");
    } else {
        text(fmt::format("{}: {:.2g}", word, node.throughput), Anchor::left, {21, -3}, "#222222");
    }
}

}  // namespace

PlaneDrawing rays_beside_tree(const Scene& scene, const RayTree& tree) {
    PlaneSketch sketch;
    add_section(sketch, scene);
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) all.push_back(i);
    add_rays(sketch, scene, tree, all, 1.2);
    const Layout layout(tree, 4.7);
    for (const std::size_t i : all)
        if (i > 0) add_edge(sketch, tree, layout, i);
    for (const std::size_t i : all) add_node(sketch, scene, tree, layout, i);
    return {
        .title = "", .low = {-4.4, -1.4}, .high = {15.2, 6.1}, .width = 1100, .height = 440, .marks = sketch.marks()};
}

}  // namespace raylab::recursion
