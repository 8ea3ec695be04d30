#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

/// The probability that a chi-square variable with this many degrees of freedom is at least `statistic`.
double chi_square_tail(double statistic, double degrees);

/// Pearson's test: the probability that counts differ from what is expected at least as much as these do, if each trial
/// falls into cell i with the probability expected[i] / their sum. Cells in which fewer than 5 are expected are pooled,
/// since the distribution of the statistic is known for many only. The sums of both are equal.
double chi_square_p_value(std::span<const std::uint64_t> counts, std::span<const double> expected);

/// The same where all cells are equally likely.
double chi_square_p_value(std::span<const std::uint64_t> counts);

}  // namespace raylab
