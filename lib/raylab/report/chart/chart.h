#pragma once

#include "raylab/report/measure.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab {

/// Writes folder/name.csv, .json, .gp, .svg and .png: error (x, log) against time (y, log), one curve or dot per
/// method, error bars, the Pareto front, direct labels. Zero error is drawn at its 95 % bound and said so. Each
/// (workload) becomes a panel where there is more than one. Without gnuplot: .csv and .json only, and a note on stderr.
/// Returns the files written.
std::vector<std::filesystem::path> write_chart(const Experiment& experiment, const std::filesystem::path& folder,
                                               const std::string& name);

/// A plain chart: named curves over x, for anything that is not speed against accuracy.
struct Curve {
    std::string name;
    std::vector<double> x, y;
    std::vector<double> low = {}, high = {};  // error bars; empty: none
};
enum class AxisKind { linear, logarithmic };
struct CurveChart {
    std::string title, x_label, y_label;
    AxisKind x_axis = AxisKind::linear, y_axis = AxisKind::linear;
    std::vector<Curve> curves;
};
std::vector<std::filesystem::path> write_chart(const CurveChart& chart, const std::filesystem::path& folder,
                                               const std::string& name);

}  // namespace raylab
