#pragma once

#include "raylab/experiment/measure/measure.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab {

/// Writes folder/name.csv, .json, .gp, .svg and .png: error (x, logarithmic) against time (y, logarithmic), one curve
/// or dot for each method, error bars, the Pareto front, direct labels. An error of zero is drawn at its 95 % bound,
/// and a note says so. Where there are several workloads, each gets a panel. Without gnuplot only .csv and .json are
/// written, with a note on stderr. Returns the files written.
std::vector<std::filesystem::path> write_chart(const Experiment& experiment, const std::filesystem::path& folder,
                                               const std::string& name);

/// A curve of a plain chart: named values over x, for charts other than speed against accuracy.
struct Curve {
    std::string name;
    std::vector<double> x, y;
    std::vector<double> low = {}, high = {};  // error bars; empty where there are none
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
