#include "raylab/accelerator/bvh8/bvh8.h"

#include "raylab/accelerator/bvh8/bvh8_leaves.h"
#include "raylab/accelerator/bvh8/bvh8_turns.h"

#include <algorithm>
#include <utility>

namespace raylab {

std::optional<Hit> Bvh8::closest(const Ray& ray, Traversal& traversal) const {
    return walks_.closest(contents_, ray, traversal);
}

std::vector<std::optional<Hit>> Bvh8::closest_of(std::span<const Ray> rays, Traversal& traversal) const {
    return wait_for_memory(rays) ? closest_in_turns(rays, cached_bytes, traversal)
                                 : Accelerator::closest_of(rays, traversal);
}

bool Bvh8::wait_for_memory(std::span<const Ray> rays) const {
    constexpr std::size_t small = std::size_t{1} << 22, large = std::size_t{1} << 28;
    const std::size_t bytes = contents_.tree().bytes();
    if (bytes <= small || bytes >= large) return bytes >= large;
    const float close = contents_.tree().reach / 16;
    std::size_t apart = 0;
    for (std::size_t i = 1; i < rays.size(); ++i) {
        const Vec3f way = glm::abs(rays[i].origin - rays[i - 1].origin);
        apart += std::max({way.x, way.y, way.z}) > close;
    }
    return 2 * apart > rays.size();
}

std::vector<std::optional<Hit>> Bvh8::closest_in_turns(std::span<const Ray> rays, std::size_t near_bytes,
                                                       Traversal& traversal) const {
    if (contents_.tree().nodes.empty()) return Accelerator::closest_of(rays, traversal);
    AnswersInTurns<NearestLeaves> turns(contents_, rays, traversal);
    walks_.nearest_in_turns(contents_.tree(), near_bytes, turns, traversal);
    return std::move(turns).answers();
}

bool Bvh8::occluded(const Ray& ray, Traversal& traversal) const { return walks_.occluded(contents_, ray, traversal); }

std::vector<bool> Bvh8::occluded_of(std::span<const Ray> rays, Traversal& traversal) const {
    return wait_for_memory(rays) ? occluded_in_turns(rays, cached_bytes, traversal)
                                 : Accelerator::occluded_of(rays, traversal);
}

std::vector<bool> Bvh8::occluded_in_turns(std::span<const Ray> rays, std::size_t near_bytes,
                                          Traversal& traversal) const {
    if (contents_.tree().nodes.empty()) return Accelerator::occluded_of(rays, traversal);
    AnswersInTurns<AnyLeaves> turns(contents_, rays, traversal);
    walks_.any_in_turns(contents_.tree(), near_bytes, turns, traversal);
    return std::move(turns).answers();
}

std::optional<Hit> Bvh8::closest_in_floats(const Ray& ray, Traversal& traversal) const {
    return walks_.closest_in_floats(contents_, ray, traversal);
}

}  // namespace raylab
