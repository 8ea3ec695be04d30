#include "raylab/report/ray_tree/ray_tree_style.h"

#include "raylab/image/color.h"
#include "raylab/report/ray_tree/ray_tree_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr std::size_t most_in_detail = 15, most_in_a_word = 160;  // numbers of nodes
constexpr double smallest_font = 13;  // in points, of words that are to be read on a page and on a screen
constexpr const char *red = "#d00000", *grey = "#8a8a8a";

std::string hex(const Color& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", srgb_byte(color.x), srgb_byte(color.y), srgb_byte(color.z));
}

// Black on light backgrounds, white on dark ones: at a luminance of 0.18 both have the same contrast (WCAG 2, 1.4.3).
const char* readable_on(const Color& ground) {
    const auto share = [](double value) { return static_cast<float>(unit_clamped(value)); };
    return luminance({share(ground.x), share(ground.y), share(ground.z)}) > 0.18 ? "#000000" : "#ffffff";
}

// "pair[2]/sphere 0" -> "sphere 0".
std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// The diameter is in inches; a node of area 1 has 0.75.
double area_of(double diameter) { return (diameter / 0.75) * (diameter / 0.75); }

// The approximate width of a text in inches: letters are about half as wide as the font is high.
double width(const std::string& text, double font) { return 0.55 * font / 72 * static_cast<double>(text.size()); }

// The throughput is clamped, because a tree that was read from a file may contain any throughput.
double share_of_pixel(const RayNode& node) { return unit_clamped(node.throughput); }

// The lines of a node that fit into its circle: both, or the number alone, or none.
std::string text_inside(double diameter, double font, const std::string& word, const std::string& number) {
    const double line = 1.2 * font / 72;
    const double chord = std::sqrt(std::max(0.0, diameter * diameter - 4 * line * line));  // of two lines' corners
    if (std::max(width(word, font), width(number, font)) < chord) return word + "\n" + number;
    return width(number, font) < 0.95 * diameter ? number : "";
}

std::string cut_lines(const std::vector<RayNode>& cut) {
    std::string text;
    for (const auto& node : cut) text += fmt::format("\n{}: {}", to_string(node.kind), why_it_ended(node.ended));
    return text;
}

std::string full_label(const RayNode& node, const std::vector<RayNode>& cut) {
    std::string text = fmt::format("{}\nthroughput {:.3g}", what_it_hit(node), node.throughput);
    if (node.density > 0) text += fmt::format("\ndensity {:.3g} / sr", node.density);
    if (node.ended != Ending::missed) text += "\nlocal " + in_words(node.local);
    text += "\nadds " + in_words(node.contribution);
    if (node.ended == Ending::diffuse) text += "\nends: " + to_string(node.ended);
    for (const auto& branch : cut)
        text += fmt::format("\n{} ends: {}", to_string(branch.kind), to_string(branch.ended));
    return text;
}

}  // namespace

RayStrokes strokes_of(RayKind kind) {
    switch (kind) {
        case RayKind::eye:
            return {"#000000", ""};
        case RayKind::reflected:
            return {"#0072b2", ""};
        case RayKind::transmitted:
            return {"#009e73", "dashed"};
        case RayKind::shadow:
            return {grey, "dotted"};
        case RayKind::diffuse:
            return {"#d55e00", "bold"};
    }
    return {"#000000", ""};
}

Detail detail_for(std::size_t nodes) {
    if (nodes <= most_in_detail) return Detail::full;
    return nodes <= most_in_a_word ? Detail::word : Detail::dot;
}

DiagramNode style_of_ray(const RayNode& node, const Color& brought, const std::vector<RayNode>& cut, Detail detail) {
    const auto [line, style] = strokes_of(node.kind);
    const bool missed = node.ended == Ending::missed;
    const double throughput = share_of_pixel(node);
    DiagramNode look{.tooltip = everything_about(node) + cut_lines(cut),
                     .fill = hex(brought),
                     .style = style,
                     .line = line,
                     .text = readable_on(brought),
                     .pen = 1.5 + 2 * throughput};
    if (detail == Detail::full) {
        look.label = full_label(node, cut);
        // Rounded where it hit nothing: an ellipse about three lines is half as wide again, and the tree would be shown
        // smaller.
        if (missed) look.style += look.style.empty() ? "rounded" : ",rounded";
        look.font = smallest_font + 3 * std::sqrt(throughput);
        return look;
    }
    look.shape = missed ? "diamond" : "circle";
    look.size = DiagramNode::Size::exact;
    const double diameter =
        (detail == Detail::word ? 0.2 : 0.1) + (detail == Detail::word ? 0.9 : 0.5) * std::sqrt(throughput);
    look.area = area_of(diameter);
    look.font = 8 + 2 * std::sqrt(throughput);
    look.label = text_inside(diameter, look.font, missed ? "sky" : last_part(node.object),
                             fmt::format("{:.2g}", node.throughput));
    return look;
}

DiagramNode style_of_shadow_ray(const RayNode& node, Detail detail) {
    const bool blocked = node.ended == Ending::blocked;
    DiagramNode look{.label = "",
                     .tooltip = everything_about(node),
                     .shape = "circle",
                     .fill = blocked ? "#606060" : "#ffffff",
                     .area = 0.015,
                     .line = grey,
                     .size = DiagramNode::Size::exact};
    if (detail != Detail::full) return look;
    look.label = what_it_hit(node);
    look.size = DiagramNode::Size::around_text;
    look.shape = "plaintext";
    look.fill = blocked ? "#d8d8d8" : "#ffffff";
    look.text = "#505050";
    look.font = smallest_font;
    return look;
}

DiagramNode style_of_cut(const RayNode& node) {
    return {.label = what_it_hit(node),
            .tooltip = everything_about(node),
            .shape = "plaintext",
            .area = 0.1,
            .text = grey,
            .font = smallest_font};
}

DiagramNode style_of(const PrunedBranches& branches) {
    return {.label = fmt::format("+{} pruned\nthroughput sum {:.2g}", branches.rays, branches.throughput),
            .tooltip = fmt::format("{} rays that are not drawn; together they add {} to the pixel", branches.rays,
                                   in_words(branches.contribution)),
            .shape = "plaintext",
            .area = 0.1,
            .text = "#505050",
            .font = smallest_font};
}

DiagramEdge edge_to(const RayNode& node, const RayNode& parent, Detail detail) {
    const auto [color, style] = strokes_of(node.kind);
    DiagramEdge edge{.from = 0, .to = 0, .color = color, .style = style};
    if (node.kind == RayKind::shadow) return edge;
    edge.pen = 1 + 4 * share_of_pixel(node);
    if (detail == Detail::full)
        edge.label = to_string(node.kind) +
                     (parent.throughput > 0 ? fmt::format(" x {:.3g}", node.throughput / parent.throughput) : "");
    return edge;
}

DiagramNode marked(const RayNode& node, DiagramNode look, const std::string& remark) {
    look.label = what_it_hit(node) + "\n" + remark;
    look.tooltip = remark + "\n" + look.tooltip;
    look.shape = "box";
    look.size = DiagramNode::Size::around_text;
    look.style = "bold";
    look.fill = "#fff0f0";
    look.line = look.text = red;
    look.pen = 5;
    look.font = 11;
    return look;
}

}  // namespace raylab
