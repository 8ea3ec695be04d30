#pragma once

#include <vector>

namespace raylab {

/// The value below which a share (0 to 1) of the sorted values lies, by linear interpolation between neighbours: type 7
/// of Hyndman and Fan, Sample Quantiles in Statistical Packages, The American Statistician 50(4), 1996. There must be
/// at least one value.
double quantile(const std::vector<double>& sorted, double share);

/// The quantile of one half.
double median(std::vector<double> values);

}  // namespace raylab
