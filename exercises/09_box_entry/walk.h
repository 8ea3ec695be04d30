#pragma once

#include "arguments.h"
#include "marbles.h"

#include "raylab/accelerator/bvh/bvh.h"
#include "raylab/accelerator/primitives.h"

#include <algorithm>
#include <array>

// The counted work: rays traverse the lab's tree of boxes, into every box that they enter by box_entry().

namespace raylab::grading::boxes {

/// The lab's tree over marbles, traversed with the box test of the function under test.
class MarbleTree {
public:
    MarbleTree() = default;
    MarbleTree(const MarbleTree&) = delete;  // primitives_ points to scene_

    /// The first hit of a ray. Each box is tested with the nearest hit so far as the end of the range, so that boxes
    /// behind it need not be entered.
    std::optional<Primitive> trace(const Ray& ray, const Answer& box_entry) const {
        Traversal traversal;
        Nearest nearest(ray);
        RayOf<double> asked = in<double>(ray);
        std::vector<std::uint32_t> waiting{0};
        while (!waiting.empty()) {
            const Outline::Node& node = tree_.nodes[waiting.back()];
            waiting.pop_back();
            std::array<double, outputs> said{};
            const auto& box = std::get<Box>(node.bound);
            box_entry(as_input({asked, convert<double>(box.min), convert<double>(box.max)}), said);
            if (said[0] == 0) continue;
            for (const std::uint32_t i : node.primitives) primitives_.test(i, ray, nearest, traversal);
            asked.range.max = std::min(asked.range.max, nearest.limit());
            const auto first = static_cast<std::ptrdiff_t>(waiting.size());
            waiting.insert(waiting.end(), node.children.begin(), node.children.end());
            std::ranges::sort(waiting.begin() + first, waiting.end(), std::ranges::greater{}, [&](std::uint32_t i) {
                return glm::dot(std::get<Box>(tree_.nodes[i].bound).center(), asked.direction);
            });  // the nearest one on top
        }
        const auto hit = nearest.hit();
        return hit ? std::optional(hit->primitive) : std::nullopt;
    }

private:
    Scene scene_ = marbles(600, 16);
    Primitives primitives_{scene_};
    Outline tree_ = BoxBvh(scene_).outline();
};

inline std::vector<WorkTask> work_tasks() {
    Dice dice(9);
    std::vector<Ray> camera, axis, anywhere;
    for (int i = 0; i < 200; ++i) {
        const Vec3d somewhere = dice.point(0.1, 15.9);
        camera.push_back({Vec3f(-7, 9, 24), convert<float>(somewhere - Vec3d(-7, 9, 24))});
        axis.push_back({convert<float>(Vec3d{somewhere.x, somewhere.y, 20}), Vec3f(0, 0, -1)});
        anywhere.push_back({convert<float>(somewhere), convert<float>(dice.direction())});
    }
    const auto across = [](const std::string& name, const std::vector<Ray>& rays) {
        return through_marbles<MarbleTree>(name, "boxes a ray", rays);
    };
    return {across("rays of a camera", camera), across("rays straight down", axis),
            across("rays from anywhere", anywhere)};
}

}  // namespace raylab::grading::boxes
