#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/triangle_hit.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace raylab {

/// "Does this ray hit that triangle, and where?", with the triangle by its index.
struct TriangleQuery {
    Ray ray;
    std::uint32_t triangle;
};

using TriangleMethod = Method<Triangle, TriangleQuery, std::optional<TriangleHit>>;

/// The seven methods of chapter 03 in float and in double, with the variants that show how two of them go wrong
/// (an absolute epsilon, moments about the world's origin); last the lab's own, filtered exact.
std::vector<TriangleMethod> ray_triangle_methods();

/// The oracle as one more method: exact, slow, and silent about u and v (they stay 0).
TriangleMethod exact_triangle_method();

/// The function in the slot of exercise 03, under the name "yours".
TriangleMethod your_triangle_method();

}  // namespace raylab
