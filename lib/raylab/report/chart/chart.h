#pragma once

#include "raylab/experiment/measure/measure.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// Writes folder/name.csv, .json, .svg and .png, and returns them. Shares of wrong answers become a heat table beside a
/// strip of times (decision_chart.h), other errors a panel of error against time for each workload (tradeoff_chart.h).
std::vector<std::filesystem::path> write_chart(const Experiment& experiment, const std::filesystem::path& folder,
                                               const std::string& name);

/// A curve of a plain chart: named values over x, for charts other than speed against accuracy.
struct Curve {
    std::string name;
    std::vector<double> x, y;
    std::vector<double> low = {}, high = {};  // error bars; empty where there are none
    std::optional<double> measured_to = {};   // beyond this x the curve goes on as it is expected to, and is dashed
    std::optional<std::size_t> look = {};     // of the palette's; otherwise its place among the curves
};
enum class AxisKind { linear, logarithmic };
struct CurveChart {
    std::string title, x_label, y_label;
    AxisKind x_axis = AxisKind::linear, y_axis = AxisKind::linear;
    std::vector<Curve> curves;
    enum class Size { page, half } size = Size::page;  // half: two stand beside each other on a page
};
/// Writes folder/name.csv, .json, .gp, .svg and .png. Without gnuplot only .csv, .json and .gp are written, with a note
/// on stderr. Returns the files written.
std::vector<std::filesystem::path> write_chart(const CurveChart& chart, const std::filesystem::path& folder,
                                               const std::string& name);

}  // namespace raylab
