#pragma once

#include "raylab/geometry/oracle.h"
#include "raylab/report/measure.h"
#include "raylab/sampling/ray_quadric_workloads.h"
#include "raylab/sampling/ray_sphere_workloads.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// What is wrong with a method's answers, against the oracle's.

namespace raylab {

/// The oracle's answers to a workload, from all threads.
using Truth = std::vector<oracle::Answer>;
Truth truth_of(const SphereWorkload& workload, int threads);
Truth truth_of(const QuadricWorkload& workload, int threads);

using Answers = std::vector<std::optional<double>>;
Answers answers_of(const SphereMethod& method, const SphereWorkload& workload);
Answers answers_of(const QuadricMethod& method, const QuadricWorkload& workload);

/// Hit or miss, wrong in parts per million of all queries.
struct WrongDecisions {
    double misses = 0, false_hits = 0;
    double all() const { return misses + false_hits; }
};
WrongDecisions wrong_decisions(std::span<const std::optional<double>> answers, const Truth& truth);

/// The error of t where both say hit: in units of the last place of the number t was computed in, and of a float.
struct TErrors {
    std::vector<double> own_ulps, float_ulps;  // sorted
};
TErrors t_errors(std::span<const std::optional<double>> answers, const Truth& truth, const std::string& number);

/// The value below which that share of sorted values lies; 0 where there is none.
double quantile(const std::vector<double>& sorted, double share);

/// The largest |t - exact t| where both say hit.
double largest_error(std::span<const std::optional<double>> answers, const Truth& truth);

/// The judges that a measurement asks.
Verdict judge_decisions(std::span<const std::optional<double>> answers, const Truth& truth);
Verdict judge_t(std::span<const std::optional<double>> answers, const Truth& truth, const std::string& number);

}  // namespace raylab
