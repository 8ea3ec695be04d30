#pragma once

#include "raylab/experiment/refraction_methods.h"
#include "raylab/report/stability.h"

#include <optional>

namespace raylab::recursion {

/// A ray at the critical angle, in the plane of its direction and the normal: where it goes in truth, and by an answer.
CaseExample example_at_critical_angle(const RefractionQuery& query, const std::optional<Vec3d>& truth,
                                      const std::optional<Vec3d>& answer);

/// A ray into a slab and out of it by an answer, where it should be parallel to itself.
CaseExample example_through_slab(const RefractionQuery& query, const Vec3d& inside, const std::optional<Vec3d>& answer);

}  // namespace raylab::recursion
