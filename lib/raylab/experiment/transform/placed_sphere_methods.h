#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/affine.h"
#include "raylab/geometry/ray.h"

#include <optional>
#include <vector>

namespace raylab {

/// "Where does this ray hit the unit sphere, placed by map number `which`?"
struct PlacedSphereQuery {
    Ray ray;
    std::size_t which;  // of the workload's maps
};

/// The maps are what is prepared (inverted); the answer is t, widened to double whatever it was computed in.
using PlacedSphereMethod = Method<Affine, PlacedSphereQuery, std::optional<double>>;

/// Four methods in float and in double, and the lab's own: filtered exact.
std::vector<PlacedSphereMethod> placed_sphere_methods();

/// The usual mistake, for stability cases: "direction made unit again", in double.
PlacedSphereMethod unit_again_method();

}  // namespace raylab
