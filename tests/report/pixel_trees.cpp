#include "raylab/report/ray_tree/pixel_trees.h"

#include "catch.h"
#include "raylab/accelerator/list.h"
#include "raylab/report/provenance.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <nlohmann/json.hpp>

#include <cmath>

using namespace raylab;

namespace {

nlohmann::json data_of(const std::string& script) {
    const std::string begin = "raylab_trees(", end = ");\n";
    REQUIRE(script.starts_with(begin));
    REQUIRE(script.ends_with(end));
    return nlohmann::json::parse(script.substr(begin.size(), script.size() - begin.size() - end.size()));
}

bool agree(const nlohmann::json& written, double value) {
    if (written.is_null()) return !std::isfinite(value);
    return std::abs(written.get<double>() - value) <= 1e-5 * std::abs(value);
}

}  // namespace

TEST_CASE("a page's script has for each picked pixel the rays of its ray tree") {
    const Scene scene = read_scene(source_folder() / "chapters/07_recursion/scene.toml");
    const List list(scene);
    const ImageSize image{64, 48};
    const WhittedOptions options{.depth = 4};
    const auto data = data_of(pixel_trees_script({scene, list, image, options, "./raylab tree"}));
    const auto& words = data["words"];
    REQUIRE(data["trees"].size() == 32 * 24);
    const CameraFrame frame = camera_frame(scene.camera, image);
    for (const std::size_t cell : {std::size_t{0}, std::size_t{32 * 14 + 20}, std::size_t{32 * 24 - 1}}) {
        const auto& [x, y, nodes] = data["trees"][cell].get<std::tuple<int, int, nlohmann::json>>();
        CHECK(x == static_cast<int>(2 * (cell % 32) + 1));
        CHECK(y == static_cast<int>(2 * (cell / 32) + 1));
        const RayTree tree = sample_tree(scene, list, frame, options, {SamplePattern::center, 1}, {x, y});
        REQUIRE(nodes.size() == tree.nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const RayNode& node = tree.nodes[i];
            CHECK(words[nodes[i][0].get<std::size_t>()] == to_string(node.kind));
            CHECK(words[nodes[i][1].get<std::size_t>()] == to_string(node.ended));
            CHECK(agree(nodes[i][3], node.throughput));
            CHECK((nodes[i].size() > 4) == was_cast(node));
            if (!was_cast(node)) continue;
            const bool is_shadow = node.kind == RayKind::shadow;
            CHECK(agree(nodes[i][5], is_shadow ? double{node.ray.range.max} : node.t));
            CHECK(agree(nodes[i][9], double{node.ray.direction.x}));
            if (!is_shadow) CHECK(words[nodes[i][4].get<std::size_t>()] == node.object);
            if (!is_shadow) CHECK(agree(nodes[i][14], node.local.z));
        }
    }
    const auto& side = data["views"][1];
    CHECK(side["right"] == nlohmann::json({0, 0, -1}));
    CHECK(side["up"] == nlohmann::json({0, 1, 0}));
    CHECK(side["outlines"].size() == data["views"][0]["outlines"].size());
}
