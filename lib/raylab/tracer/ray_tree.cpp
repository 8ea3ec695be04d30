#include "raylab/tracer/ray_tree.h"

#include <array>

namespace raylab {

std::string to_string(RayKind kind) {
    static const std::array<const char*, 4> names{"eye", "reflected", "transmitted", "shadow"};
    return names[static_cast<std::size_t>(kind)];
}

std::string to_string(Ending ending) {
    static const std::array<const char*, 8> names{"branched", "diffuse", "depth",   "threshold",
                                                  "missed",   "total reflection", "reached", "blocked"};
    return names[static_cast<std::size_t>(ending)];
}

}  // namespace raylab
