#pragma once

#include "raylab/accelerator/trace_rays.h"
#include "raylab/scene/scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace raylab::bench {

/// Rays, and what they hit in exact arithmetic.
struct Rays {
    std::vector<Ray> rays;
    std::vector<std::int32_t> nearest;  // the triangle, or none
};

/// What is raced over: rays, and what is asked of them.
struct RaySet {
    std::string name;
    RayQuestion question;
    std::shared_ptr<const Rays> rays;
};

/// primary, bounce, segments: the nearest hit; bounce_any, shadow, segments_any: whether there is one.
std::vector<std::string> usual_rays();

/// Error names the known kinds of rays.
void refuse_unknown_rays(const std::string& name);

/// Sets of size * size rays each through a scene of one mesh. Error names the known ones.
/// primary: a camera's, line by line. bounce: from what those hit, into the half-space above, by the cosine. shadow:
/// from there to one point. segments: between any two points of the mesh's box. aimed: from such points at vertices and
/// at the middle of edges; not a usual kind. The lab's own rays leave a surface by naming its primitive; here, where
/// others race too, they start a ten-thousandth of the mesh's size above it.
std::vector<RaySet> ray_sets(const Scene& scene, const std::vector<std::string>& names, int size);

}  // namespace raylab::bench
