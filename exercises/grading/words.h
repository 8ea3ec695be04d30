#pragma once

#include "raylab/geometry/vector.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace raylab::grading {

/// Numbers as a verdict shows them: with ten digits, which is more than a judge requires.
inline std::string words(double value) { return std::isnan(value) ? "not a number" : fmt::format("{:.10g}", value); }

inline std::string words(const Vec3d& v) { return fmt::format("({}, {}, {})", words(v.x), words(v.y), words(v.z)); }

}  // namespace raylab::grading
