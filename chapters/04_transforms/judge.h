#pragma once

#include "workloads.h"

#include "raylab/experiment/measure/wrong_decisions.h"

#include <optional>
#include <span>

namespace raylab::transforms {

/// The oracle's answers to a workload, one for each query. It takes some 50 microseconds for each and uses all cores.
std::vector<std::optional<double>> truth(const SphereWorkload& workload, int threads);

/// Wrong decisions in ppm, with misses and false hits apart, and the largest relative error of t among right hits.
Judgement judge_hits(std::span<const std::optional<double>> truth, std::span<const std::optional<double>> answers);

std::vector<Vec3d> truth(const NormalWorkload& workload);

/// The worst angle to the exact normal, in radians (pi where the answer is NaN), and how many point inward.
Judgement judge_normals(std::span<const Vec3d> truth, std::span<const Vec3d> answers);

}  // namespace raylab::transforms
