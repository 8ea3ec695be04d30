#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/vector.h"

#include <array>
#include <variant>
#include <vector>

namespace raylab {

/// "What is the unit normal of this surface, once these columns have carried it?"
struct NormalQuery {
    std::array<Vec3f, 3> columns;
    Vec3f normal;
};

using NormalMethod = Method<std::monostate, NormalQuery, Vec3d>;

/// Carried like a point (wrong), inverse transpose by division, cofactors with and without the determinant's sign; in
/// float and in double.
std::vector<NormalMethod> normal_methods();

/// The function in the slot of exercise 04, under the name "yours".
NormalMethod your_normal_method();

/// The truth: two tangents carried and crossed in exact arithmetic, rounded once, made unit in double.
Vec3d exact_normal(const NormalQuery& query);

}  // namespace raylab
