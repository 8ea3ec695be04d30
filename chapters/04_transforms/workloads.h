#pragma once

#include "raylab/experiment/transform/normal_methods.h"
#include "raylab/experiment/transform/placed_sphere_methods.h"

#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace raylab::transforms {

using SphereWorkload = Workload<Affine, PlacedSphereQuery>;
using NormalWorkload = Workload<std::monostate, NormalQuery>;

/// Placed unit spheres and rays aimed at their silhouettes, where decisions are hard: rotated, stretched, sheared,
/// mirrored, far from the origin, flattened, tiny.
std::vector<SphereWorkload> sphere_workloads(std::size_t rays, std::uint64_t seed);

/// Transforms and normals: rotated, stretched, sheared, mirrored, flattened, tiny.
std::vector<NormalWorkload> normal_workloads(std::size_t normals, std::uint64_t seed);

/// One workload by its name, which must be known (an assertion).
template <class Work>
const Work& named(const std::vector<Work>& workloads, const std::string& name) {
    for (const auto& workload : workloads)
        if (workload.name == name) return workload;
    assert(!"a workload with this name");
    std::abort();
}

}  // namespace raylab::transforms
