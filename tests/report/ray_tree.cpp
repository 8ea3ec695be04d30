#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/report/json_text.h"
#include "raylab/report/ray_tree/ray_tree_diagram.h"
#include "raylab/report/ray_tree/ray_tree_difference_report.h"
#include "raylab/report/ray_tree/ray_tree_json.h"
#include "raylab/report/ray_tree/ray_tree_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace raylab;

namespace {

constexpr int full_depth = 10;

// A full binary tree: 0.3 of every ray is reflected, 0.7 transmitted.
void grow(RayTree& tree, RayKind kind, std::size_t parent, int depth, double throughput, int deepest) {
    const std::size_t me = tree.nodes.size();
    const Color local{0.1, 0.2 + 0.1 * static_cast<double>(me % 3), 0.3};
    tree.nodes.push_back({.kind = kind,
                          .ended = depth == deepest ? Ending::diffuse : Ending::branched,
                          .parent = parent,
                          .depth = depth,
                          .throughput = throughput,
                          .ray = {.origin = {1, 2, 3}, .direction = {0.1f, 0, -1}, .range = {0, 7}, .leaving = {2, 1}},
                          .object = "pair[2]/sphere 0",
                          .t = 1.0 / 3,
                          .point = {0.1, 0.2, 0.3},
                          .normal = {0, 0.6, 0.8},
                          .local = local,
                          .contribution = throughput * local});
    tree.pixel += throughput * local;
    if (depth == deepest) return;
    grow(tree, RayKind::reflected, me, depth + 1, 0.3 * throughput, deepest);
    grow(tree, RayKind::transmitted, me, depth + 1, 0.7 * throughput, deepest);
}

RayTree binary_tree(int deepest) {
    RayTree tree;
    grow(tree, RayKind::eye, RayNode::none, 1, 1, deepest);
    return tree;
}

std::size_t red_nodes(const Diagram& diagram) {
    return static_cast<std::size_t>(std::ranges::count_if(diagram.nodes, [](const auto& node) {
        return node.line == "#d00000" && node.pen > 3 && node.style == "bold";
    }));
}

}  // namespace

TEST_CASE("a ray tree comes back from JSON as it was, bit for bit") {
    RayTree tree = binary_tree(3);
    tree.nodes.push_back({.kind = RayKind::shadow, .ended = Ending::reached, .parent = 1, .light = 2});
    tree.nodes.push_back({.kind = RayKind::transmitted, .ended = Ending::total_internal_reflection, .parent = 2});
    tree.nodes[6].t = std::numeric_limits<double>::infinity();
    tree.nodes[3].ray.time = 1.0f / 3;
    const auto text = json_text(to_json(tree));
    const RayTree back = ray_tree_from_json(text, "a.json");
    CHECK(json_text(to_json(back)) == text);
    REQUIRE(back.nodes.size() == tree.nodes.size());
    CHECK(back.nodes[3].t == 1.0 / 3);
    CHECK(back.nodes[3].ray.direction == tree.nodes[3].ray.direction);
    CHECK(back.nodes[3].ray.leaving == Primitive{2, 1});
    CHECK(back.nodes[3].ray.time == 1.0f / 3);
    CHECK(back.nodes[2].ray.time == 0);
    CHECK(everything_about(back.nodes[3]).find("at time 0.333333343 s\n") != std::string::npos);
    CHECK(everything_about(back.nodes[2]).find("at time") == std::string::npos);
    CHECK(back.nodes[6].t == std::numeric_limits<double>::infinity());
    CHECK(back.nodes[7].light == 2);
    CHECK(back.pixel == tree.pixel);
}

TEST_CASE("a ray tree of a file with former words is read") {
    RayTree tree = binary_tree(3);
    tree.nodes.push_back({.kind = RayKind::transmitted, .ended = Ending::total_internal_reflection, .parent = 2});
    auto json = nlohmann::ordered_json::parse(json_text(to_json(tree)));
    for (auto& node : json["nodes"]) {
        node["weight"] = node["throughput"];
        node.erase("throughput");
        if (node["ended"] == "total internal reflection") node["ended"] = "total reflection";
    }
    const RayTree read = ray_tree_from_json(json.dump(), "old.json");
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) CHECK(read.nodes[i].throughput == tree.nodes[i].throughput);
    CHECK(read.nodes.back().ended == Ending::total_internal_reflection);
}

TEST_CASE("what is not a ray tree is refused with its place") {
    const auto tree = to_json(binary_tree(2));
    const auto refusal = [&](const auto& change) -> std::string {
        auto json = tree;
        change(json);
        try {
            ray_tree_from_json(json.dump(), "a.json");
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    };
    using Json = nlohmann::ordered_json;
    CHECK(refusal([](Json&) {}) == "accepted");
    CHECK(refusal([](Json& j) {
              j["nodes"][1]["kind"] = "blue";
          }).starts_with("a.json /nodes/1/kind: expected eye, reflected"));
    CHECK(refusal([](Json& j) {
              j["nodes"][1]["parent"] = 1;
          }).starts_with("a.json /nodes/1/parent: expected a whole number below 1"));
    CHECK(refusal([](Json& j) { j["nodes"][0]["parent"] = 0; }).starts_with("a.json /nodes/0/parent: expected null"));
    CHECK(refusal([](Json& j) {
              j["nodes"][1]["point"] = {1, 2};
          }).starts_with("a.json /nodes/1/point: expected three numbers"));
    CHECK(refusal([](Json& j) {
              j["nodes"][1].erase("t");
          }).starts_with("a.json /nodes/1/t: expected a value, found none"));
    CHECK(refusal([](Json& j) { j["nodes"] = Json::array(); }).starts_with("a.json /nodes: expected at least"));
    CHECK(refusal([](Json& j) { j["raylab"] = "scene"; }).starts_with("a.json: expected a ray tree"));
    CHECK_THROWS_AS(ray_tree_from_json("{", "a.json"), Error);
    CHECK_THROWS_AS(ray_tree_from_json("[1, 2]", "a.json"), Error);
}

TEST_CASE("what is pruned is summed: nothing of the pixel and no ray is lost") {
    const RayTree tree = binary_tree(full_depth);
    REQUIRE(tree.nodes.size() == 1023);
    for (const std::optional<double> prune : {std::optional<double>{}, std::optional<double>{0.0},
                                              std::optional<double>{0.02}, std::optional<double>{0.9}}) {
        const auto shown = shown_tree(tree, {.prune = prune});
        std::size_t rays = shown.nodes.size();
        Color sum{0, 0, 0};
        for (const std::size_t i : shown.nodes) sum += tree.nodes[i].contribution;
        for (const auto& branches : shown.pruned) {
            rays += branches.rays;
            sum += branches.contribution;
        }
        CHECK(rays == tree.nodes.size());
        CHECK(glm::length(sum - tree.pixel) < 1e-12);
        if (!prune) CHECK(shown.nodes.size() == RayTreeView{}.largest);
        if (prune == 0.0) CHECK(shown.pruned.empty());
        if (prune == 0.9) CHECK(shown.nodes.size() == 1);
    }
}

TEST_CASE("the throughput of pruned branches is that of the rays cut off, not of those behind them too") {
    const auto shown = shown_tree(binary_tree(full_depth), {.prune = 0.9});
    REQUIRE(shown.pruned.size() == 1);
    CHECK_THAT(shown.pruned[0].throughput, WithinRel(1.0, 1e-12));  // 0.3 and 0.7
}

TEST_CASE("the colour that a ray brings is its own and its children's") {
    const RayTree tree = binary_tree(4);
    const auto brought = shown_tree(tree, {}).brought;
    const auto below = children(tree);
    CHECK(glm::length(brought[0] - tree.pixel) < 1e-14);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        Color expected = tree.nodes[i].local;
        for (const std::size_t child : below[i])
            expected += (tree.nodes[child].kind == RayKind::reflected ? 0.3 : 0.7) * brought[child];
        CHECK(glm::length(brought[i] - expected) < 1e-14);
    }
}

TEST_CASE(
    "kinds differ by colour and by line, labels are detailed up to 15 nodes, and all numbers are in the tooltips") {
    const auto small = ray_tree_diagram(binary_tree(4), "small");
    REQUIRE(small.nodes.size() == 15);
    CHECK(small.edges[0].color != small.edges.back().color);
    CHECK(small.edges[0].style != small.edges.back().style);
    CHECK(small.nodes[1].label.find("throughput 0.3") != std::string::npos);
    const auto large = ray_tree_diagram(binary_tree(5), "large");
    REQUIRE(large.nodes.size() == 31);
    CHECK(large.nodes[0].label == "sphere 0\n1");
    for (const auto* word : {"reflected ray, depth 2, throughput 0.3", "pair[2]/sphere 0 at t = 0.333333333",
                             "point (0.1", "normal (0", "local colour (0.1", "adds ("})
        CHECK(large.nodes[1].tooltip.find(word) != std::string::npos);
    CHECK(large.nodes[1].area > large.nodes[2].area);
    CHECK(ray_tree_diagram(binary_tree(full_depth), "").nodes.size() < 80);
    CHECK(ray_tree_diagram(binary_tree(full_depth), "", {.prune = 0}).layout == Diagram::Layout::radial);
}

TEST_CASE("a tree of what is no number is drawn, too, and comes back") {
    RayTree tree = binary_tree(7);
    for (std::size_t i = 0; i < tree.nodes.size(); i += 3)
        tree.nodes[i].throughput = tree.nodes[i].local.x = std::nan("");
    tree.nodes[1].throughput = 1e300;
    tree.nodes[1].depth = -3;
    const auto diagram = ray_tree_diagram(tree, "");
    CHECK(diagram.nodes.size() > 5);
    for (const auto& node : diagram.nodes) CHECK((node.area > 0 && node.area < 100 && node.pen < 10));
    CHECK(ray_tree_from_json(json_text(to_json(tree)), "a").nodes[1].depth == -3);
}

TEST_CASE("shadow rays are drawn on request, and branches that were cut are told by their parents") {
    RayTree tree = binary_tree(2);
    tree.nodes.push_back({.kind = RayKind::shadow, .ended = Ending::blocked, .parent = 1, .light = 0});
    tree.nodes.push_back({.kind = RayKind::transmitted, .ended = Ending::threshold, .parent = 1});
    CHECK(ray_tree_diagram(tree, "").nodes.size() == 3);
    CHECK(ray_tree_diagram(tree, "").nodes[1].label.find("transmitted ends: threshold") != std::string::npos);
    CHECK(ray_tree_diagram(tree, "", {.shadow_rays = RayTreeView::ShadowRays::shown}).nodes.size() == 4);
}

TEST_CASE("the first node that differs is red and thick in both trees, even where it would be pruned") {
    const RayTree expected = binary_tree(full_depth);
    RayTree got = expected;
    const std::size_t lightest = 9;  // reflected nine times
    REQUIRE(got.nodes[lightest].depth == full_depth);
    got.nodes[lightest].local *= 2;
    const auto difference = first_difference(got, expected);
    REQUIRE(difference);
    const auto diagram = difference_diagram({got, "yours"}, {expected, "the reference"}, difference);
    CHECK(red_nodes(diagram) == 2);
    const auto red = std::ranges::find(diagram.nodes, "#d00000", &DiagramNode::line);
    CHECK(red->label.find("local colour: (0.2") != std::string::npos);
    CHECK(diagram.groups == std::vector<std::string>{"yours", "the reference"});
    CHECK(red_nodes(difference_diagram({got, ""}, {got, ""}, {})) == 0);
    CHECK(to_json(difference)["fields"][0]["field"] == "local colour");
    CHECK(to_json(std::optional<RayTreeDifference>{})["same"] == true);
}
