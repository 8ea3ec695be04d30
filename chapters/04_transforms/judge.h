#pragma once

#include "workloads.h"

#include "raylab/report/wrong_decisions.h"

#include <optional>
#include <span>

namespace raylab::transforms {

/// The oracle's answers to a workload, one per query. Takes some 50 microseconds a query and all cores.
std::vector<std::optional<double>> truth(const SphereWorkload& workload, int threads);

/// Wrong decisions in ppm, misses and false hits apart, and the largest relative error of t among right hits.
Verdict judge_hits(std::span<const std::optional<double>> truth, std::span<const std::optional<double>> answers);

std::vector<Vec3d> truth(const NormalWorkload& workload);

/// The worst angle to the true normal, in radians (pi where the answer is not a number), and how many point inward.
Verdict judge_normals(std::span<const Vec3d> truth, std::span<const Vec3d> answers);

}  // namespace raylab::transforms
