#pragma once

#include "raylab/accelerator/trace_rays.h"
#include "raylab/scene/scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace raylab::bench {

/// Rays, and what they hit by exact arithmetic.
struct Rays {
    std::vector<Ray> rays;
    std::vector<std::int32_t> nearest;  // the triangle, or none
};

/// Rays, and the query that is made with them.
struct RaySet {
    std::string name;
    RayQuestion question;
    std::shared_ptr<const Rays> rays;
};

/// primary, bounce, segments: the nearest hit; bounce_any, shadow, segments_any: whether there is a hit.
std::vector<std::string> usual_rays();

/// Throws an Error, which lists the known kinds of rays, for an unknown one.
void refuse_unknown_rays(const std::string& name);

/// Sets of size * size rays each through a scene of one mesh. An Error lists the known sets:
/// primary: the rays of a camera, line by line. bounce: from the points that those hit, into the half-space above, with
/// the cosine's distribution. shadow: from those points to one point. segments: between any two points of the mesh's
/// box. aimed: from such points at vertices and at the middle of edges; not a usual kind. The lab's own rays leave a
/// surface by naming its primitive; here they start a ten-thousandth of the mesh's size above it, as other libraries
/// require.
std::vector<RaySet> ray_sets(const Scene& scene, const std::vector<std::string>& names, int size);

}  // namespace raylab::bench
