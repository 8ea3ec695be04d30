#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace raylab {

/// "Does this ray hit that polygon, and at which t?", with the polygon by its index.
struct PolygonQuery {
    Ray ray;
    std::uint32_t polygon;
};

using PolygonMethod = Method<Polygon, PolygonQuery, std::optional<double>>;

/// Half-planes, projection with the even-odd rule, and the fan of triangles, each in float and double; last the lab's
/// own, filtered exact.
std::vector<PolygonMethod> ray_polygon_methods();

}  // namespace raylab
