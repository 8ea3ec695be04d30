#include "raylab/report/structure/structure_diagram.h"

#include "raylab/report/structure/bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

namespace raylab {

namespace {

constexpr double font = 13;  // in points

// The number of nodes and primitives of a subtree, its root included.
struct Below {
    std::size_t nodes = 0, primitives = 0;
};

Below below(const Outline& outline, std::uint32_t root) {
    Below sum;
    std::vector<std::uint32_t> waiting{root};
    while (!waiting.empty()) {
        const Outline::Node& node = outline.nodes[waiting.back()];
        waiting.pop_back();
        ++sum.nodes;
        sum.primitives += node.primitives.size();
        waiting.insert(waiting.end(), node.children.begin(), node.children.end());
    }
    return sum;
}

std::string list_of(const std::vector<std::uint32_t>& primitives) {
    constexpr std::size_t largest = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(largest, primitives.size()); ++i)
        text += (i > 0 ? " " : "") + std::to_string(primitives[i]);
    return primitives.size() > largest ? fmt::format("{} ... ({})", text, primitives.size()) : text;
}

class Drawing {
public:
    Drawing(const Outline& outline, const StructureDiagramView& view) : outline_(outline), view_(view) {}

    // Draws the upper levels first, as many nodes as there is room for.
    void draw() {
        if (outline_.nodes.empty()) return;
        std::deque<std::pair<std::uint32_t, std::size_t>> waiting;  // an outline's node, and its place in the diagram
        waiting.push_back({0, add(0)});
        while (!waiting.empty()) {
            const auto [number, place] = waiting.front();
            waiting.pop_front();
            const auto& children = outline_.nodes[number].children;
            const std::size_t room = view_.largest > drawn_ ? view_.largest - drawn_ : 0;
            const std::size_t shown = children.size() <= room                        ? children.size()
                                      : outline_.nodes.size() - 1 == children.size() ? room
                                                                                     : 0;
            for (std::size_t i = 0; i < shown; ++i) {
                const std::size_t child = add(children[i]);
                diagram.edges.push_back({.from = place, .to = child});
                waiting.push_back({children[i], child});
            }
            if (shown < children.size()) leave_out(place, std::span(children).subspan(shown));
        }
    }

    std::size_t drawn() const { return drawn_; }
    Diagram diagram;

private:
    std::size_t add(std::uint32_t number) {
        const Outline::Node& node = outline_.nodes[number];
        const bool is_leaf = node.children.empty();
        DiagramNode look{.label = node.label,
                         .tooltip = words(node.bound),
                         .shape = is_leaf ? "box" : "ellipse",
                         .area = 0.5,
                         .font = font};
        if (is_leaf && node.primitives.empty()) look.style = "dashed";
        if (!node.primitives.empty()) {
            look.label += (look.label.empty() ? "" : "\n") + list_of(node.primitives);
            look.fill = "#fdecc8";
        }
        mark(look, node.bound);
        diagram.nodes.push_back(look);
        ++drawn_;
        return diagram.nodes.size() - 1;
    }

    void mark(DiagramNode& look, const Bound& bound) const {
        for (std::size_t i = 0; i < view_.visits.size(); ++i) {
            if (!same(view_.visits[i].bound, bound)) continue;
            look.label = fmt::format("({})", i + 1) + (look.label.empty() ? "" : "\n" + look.label);
            look.pen = 2.5;
            look.line = "#d55e00";
            return;
        }
    }

    void leave_out(std::size_t place, std::span<const std::uint32_t> children) {
        Below sum;
        for (const std::uint32_t child : children) {
            const Below more = below(outline_, child);
            sum.nodes += more.nodes;
            sum.primitives += more.primitives;
        }
        diagram.nodes.push_back(
            {.label = fmt::format("{} node{},\n{} primitive{}", sum.nodes, sum.nodes == 1 ? "" : "s", sum.primitives,
                                  sum.primitives == 1 ? "" : "s"),
             .shape = "plaintext",
             .line = "#8a8a8a",
             .text = "#666670",
             .font = font});
        diagram.edges.push_back({.from = place, .to = diagram.nodes.size() - 1, .color = "#8a8a8a", .style = "dotted"});
    }

    const Outline& outline_;
    const StructureDiagramView& view_;
    std::size_t drawn_ = 0;
};

}  // namespace

Diagram structure_diagram(const Outline& outline, const std::string& title, const StructureDiagramView& view) {
    Drawing drawing(outline, view);
    drawing.draw();
    const std::size_t all = outline.nodes.size();
    drawing.diagram.title =
        title + (drawing.drawn() < all ? fmt::format("\n{} of {} nodes are drawn", drawing.drawn(), all) : "");
    return drawing.diagram;
}

}  // namespace raylab
