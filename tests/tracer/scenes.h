#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/whitted/whitted.h"

#include <memory>
#include <string>
#include <vector>

// Small scenes of mirrors and glass, given as text.

namespace raylab::test {

/// A scene with what finds hits in it.
struct Stage {
    explicit Stage(const std::string& text, const std::string& accelerator_name = "list")
        : scene(read_scene_text("raylab = 1\n" + text, "test.toml")),
          accelerator(make_accelerator(accelerator_name, scene)) {}

    RayTree tree(const Vec3d& from, const Vec3d& direction, const WhittedOptions& options = {}) const {
        return ray_tree(scene, *accelerator, options, {convert<float>(from), convert<float>(direction)});
    }

    Scene scene;
    std::unique_ptr<Accelerator> accelerator;
};

/// The rays of one kind, in the order they were cast.
inline std::vector<RayNode> of_kind(const RayTree& tree, RayKind kind) {
    std::vector<RayNode> nodes;
    for (const auto& node : tree.nodes)
        if (node.kind == kind) nodes.push_back(node);
    return nodes;
}

inline const std::string glass = R"(
[material.glass]
diffuse = [0, 0, 0]
kt = 1
ior = 1.5
)";

}  // namespace raylab::test
