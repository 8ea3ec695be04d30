#pragma once

#include "raylab/geometry/vector.h"

#include <fmt/format.h>

#include <string>

namespace raylab::grading {

/// Numbers as a verdict shows them: with ten digits, which is more than a judge requires.
inline std::string words(double value) { return fmt::format("{:.10g}", value); }

inline std::string words(const Vec3d& v) { return fmt::format("({:.10g}, {:.10g}, {:.10g})", v.x, v.y, v.z); }

}  // namespace raylab::grading
