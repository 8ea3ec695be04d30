#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/ray_file.h"
#include "raylab/geometry/shapes.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace raylab {

/// The question for every ray: its nearest hit inside its range, or only whether there is a hit.
enum class RayQuestion { nearest, any };

struct TraceOptions {
    std::string accelerator = "auto";  // a name that make_accelerator() knows
    RayQuestion question = RayQuestion::nearest;
    int threads = 0;  // 0: all cores
};

/// The answers, and their cost.
struct TraceResult {
    std::string accelerator;      // the structure that answered, with "auto" resolved
    std::vector<HitRecord> hits;  // hits[i] answers rays[i]; for RayQuestion::any triangle is 0 or -1, and t = 0
    Traversal counts;             // over all rays
    double build_seconds = 0, seconds = 0;
    std::size_t bytes = 0;  // of the accelerator, in addition to the mesh
    int threads = 1;
};

/// Traces rays through one mesh. The hits are the same bits for every accelerator and any number of threads.
TraceResult trace_rays(std::shared_ptr<const Mesh> mesh, std::span<const Ray> rays, const TraceOptions& options = {});

}  // namespace raylab
