#include "ray_counts.h"

#include <nlohmann/json.hpp>

namespace raylab {

nlohmann::ordered_json to_json(const RayCounts& rays, const Traversal& traversal) {
    const auto kind = [](const CastAndHit& counts) {
        return nlohmann::ordered_json{{"cast", counts.cast}, {"hit", counts.hit}};
    };
    return {{"primary", kind(rays.primary)},
            {"shadow", kind(rays.shadow)},
            {"secondary", kind(rays.secondary)},
            {"box_tests", traversal.box_tests},
            {"steps", traversal.steps},
            {"primitive_tests", traversal.primitive_tests},
            {"exact_decisions", traversal.exact_decisions}};
}

std::uint64_t all_cast(const RayCounts& rays) { return rays.primary.cast + rays.shadow.cast + rays.secondary.cast; }

double rate(std::uint64_t rays, double seconds) { return seconds > 0 ? static_cast<double>(rays) / seconds : 0; }

}  // namespace raylab
