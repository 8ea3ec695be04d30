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

/// What is asked of every ray: the nearest hit inside its range, or only whether there is one.
enum class RayQuestion { nearest, any };

struct TraceOptions {
    std::string accelerator = "auto";  // as make_accelerator knows them
    RayQuestion question = RayQuestion::nearest;
    int threads = 0;  // 0: all cores
};

/// The answers, and what they cost.
struct TraceResult {
    std::string accelerator;      // which structure answered, "auto" resolved
    std::vector<HitRecord> hits;  // hits[i] answers rays[i]; RayQuestion::any: triangle 0 or -1, and t = 0
    Traversal counts;             // over all rays
    double build_seconds = 0, seconds = 0;
    std::size_t bytes = 0;  // of the accelerator, beyond the mesh
    int threads = 1;
};

/// Traces rays through one mesh. The hits are the same bits for every accelerator and any number of threads.
TraceResult trace_rays(std::shared_ptr<const Mesh> mesh, std::span<const Ray> rays, const TraceOptions& options = {});

}  // namespace raylab
