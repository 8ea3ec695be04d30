#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <optional>
#include <variant>
#include <vector>

namespace raylab {

/// "Where does this ray hit this sphere first?" Each query brings its own sphere: there is nothing to prepare.
struct SphereQuery {
    Ray ray;
    Sphere sphere;
};

/// The answer is t, widened to double whatever it was computed in.
using SphereMethod = Method<std::monostate, SphereQuery, std::optional<double>>;

/// Four methods from the literature in float and in double, one of them in long double, and the lab's own: filtered
/// exact.
std::vector<SphereMethod> ray_sphere_methods();

/// The oracle as one more method: exact and slow.
SphereMethod exact_sphere_method();

/// The function in the slot of exercise 02, under the name "yours".
SphereMethod your_sphere_method();

}  // namespace raylab
