#include "recursion_end.h"

#include "raylab/scene/needs.h"

#include <fmt/format.h>

namespace raylab {

RecursionEnd recursion_end(const Arguments& arguments, const RecursionEndOptions& options) {
    const bool depth_named = arguments.has("--depth");
    const NeedsOptions needs;
    return {
        .depth = depth_named ? static_cast<int>(arguments.integer("--depth", 1, options.deepest)) : needs.depth_limit,
        .threshold = arguments.has(options.threshold) ? arguments.number(options.threshold)
                     : depth_named                    ? 0
                                                      : needs.threshold};
}

std::string in_words(const RecursionEnd& end) {
    if (end.depth == 1) return "no ray goes on from a surface";
    const std::string depth = fmt::format("rays are followed to depth {}", end.depth);
    return end.threshold > 0 ? depth + fmt::format(" while their throughput is above {:.2g}", end.threshold) : depth;
}

}  // namespace raylab
