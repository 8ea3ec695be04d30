#pragma once

#include "raylab/experiment/measure/wrong_decisions.h"
#include "raylab/experiment/ray_quadric/ray_quadric_workloads.h"
#include "raylab/experiment/ray_sphere/ray_sphere_workloads.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// Compares the t of a method's hits with the oracle's.

namespace raylab {

/// The oracle's answers to a workload, by this many threads (0: all cores).
Truth truth_of(const SphereWorkload& workload, int threads);
Truth truth_of(const QuadricWorkload& workload, int threads);

using Answers = std::vector<std::optional<double>>;

/// The error of t where both say hit, in units of the last place of the number type in which t was computed, and of a
/// float.
struct TErrors {
    std::vector<double> own_ulps, float_ulps;  // sorted
};
TErrors t_errors(std::span<const std::optional<double>> answers, const Truth& truth, const std::string& number);

/// The largest |t - exact t| where both say hit.
double largest_error(std::span<const std::optional<double>> answers, const Truth& truth);

/// The judge that a measurement of t calls.
Judgement judge_t(std::span<const std::optional<double>> answers, const Truth& truth, const std::string& number);

}  // namespace raylab
