#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/whitted/whitted.h"

#include <nlohmann/json_fwd.hpp>

namespace raylab {

/// What `raylab render --json` says of every picture's work, whatever drew it: {primary, shadow, secondary, each
/// {cast, hit}, box_tests, steps, primitive_tests, exact_decisions}.
nlohmann::ordered_json to_json(const RayCounts& rays, const Traversal& traversal);

/// All rays of all kinds.
std::uint64_t all_cast(const RayCounts& rays);

/// Rays a second; 0 where none was cast, which takes no time.
double rate(std::uint64_t rays, double seconds);

}  // namespace raylab
