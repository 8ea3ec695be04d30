#pragma once

#include "raylab/report/wrong_decisions.h"
#include "raylab/sampling/ray_quadric_workloads.h"
#include "raylab/sampling/ray_sphere_workloads.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// Where a ray hits: what is wrong with a method's t, against the oracle's.

namespace raylab {

/// The oracle's answers to a workload, from all threads (0) or some.
Truth truth_of(const SphereWorkload& workload, int threads);
Truth truth_of(const QuadricWorkload& workload, int threads);

using Answers = std::vector<std::optional<double>>;

/// The error of t where both say hit: in units of the last place of the number t was computed in, and of a float.
struct TErrors {
    std::vector<double> own_ulps, float_ulps;  // sorted
};
TErrors t_errors(std::span<const std::optional<double>> answers, const Truth& truth, const std::string& number);

/// The largest |t - exact t| where both say hit.
double largest_error(std::span<const std::optional<double>> answers, const Truth& truth);

/// The judge that a measurement of t asks.
Verdict judge_t(std::span<const std::optional<double>> answers, const Truth& truth, const std::string& number);

}  // namespace raylab
