#include "raylab/report/ray_tree/ray_tree_difference_report.h"

#include "raylab/report/ray_tree/ray_tree_diagram.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab {

namespace {

// In a node of a diagram; further fields, which follow from the first ones, are left out.
constexpr std::size_t max_fields = 4;

// The values of one of the trees in all fields that differ.
std::string remark(const RayTreeDifference& difference, std::string DifferingField::*side) {
    std::string text = "FIRST DIFFERENCE";
    for (std::size_t i = 0; i < std::min(max_fields, difference.fields.size()); ++i)
        text += "\n" + difference.fields[i].name + ": " + difference.fields[i].*side;
    return text;
}

}  // namespace

Diagram difference_diagram(const TitledTree& got, const TitledTree& expected,
                           const std::optional<RayTreeDifference>& difference, const RayTreeView& view) {
    MarkedTree one{got.tree, got.title, {}, {}}, other{expected.tree, expected.title, {}, {}};
    if (!difference) return ray_trees_diagram(one, other, "The same tree", view);
    one.marked = difference->got;
    one.remark = remark(*difference, &DifferingField::got);
    other.marked = difference->expected;
    other.remark = remark(*difference, &DifferingField::expected);
    return ray_trees_diagram(one, other, "The first node that differs is " + difference->place, view);
}

nlohmann::ordered_json to_json(const std::optional<RayTreeDifference>& difference) {
    if (!difference) return {{"same", true}};
    const auto node = [](std::size_t index, bool is_there) {
        return is_there ? nlohmann::ordered_json(index) : nullptr;
    };
    nlohmann::ordered_json json{
        {"same", false},
        {"place", difference->place},
        {"got_node", node(difference->got, difference->in != RayTreeDifference::In::expected)},
        {"expected_node", node(difference->expected, difference->in != RayTreeDifference::In::got)},
        {"fields", nlohmann::ordered_json::array()}};
    for (const auto& [name, mine, truth] : difference->fields)
        json["fields"].push_back({{"field", name}, {"expected", truth}, {"got", mine}});
    return json;
}

}  // namespace raylab
