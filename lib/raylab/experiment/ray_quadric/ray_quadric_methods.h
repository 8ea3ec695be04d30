#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/quadric.h"
#include "raylab/geometry/ray.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace raylab {

/// "Where does this ray hit this quadric first?" The quadrics are the data, a query names one by its index.
struct QuadricQuery {
    Ray ray;
    std::size_t quadric;
};

/// The answer is t, widened to double whatever it was computed in.
using QuadricMethod = Method<Quadric, QuadricQuery, std::optional<double>>;

/// The general quadric method in float, double and long double, and the lab's own: filtered exact.
std::vector<QuadricMethod> ray_quadric_methods();

/// The oracle as one more method: exact and slow.
QuadricMethod exact_quadric_method();

/// The quadric as one of a scene's shapes.
Shape as_shape(const Quadric& quadric);

}  // namespace raylab
