#pragma once

#include "raylab/experiment/structure/structure_workload.h"
#include "raylab/geometry/ray.h"
#include "raylab/report/stability.h"
#include "raylab/scene/scene.h"

#include <optional>

namespace raylab {

/// A ray about which a structure is wrong, drawn in a plane through it: what it hits first in truth, and what the
/// structure answers. Spheres and triangles, also of meshes, are drawn where the plane cuts them.
CaseExample wrong_hit(const Ray& ray, const Scene& scene, RayQuestion question, const std::optional<Hit>& given);

}  // namespace raylab
