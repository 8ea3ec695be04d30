#pragma once

#include "raylab/report/chart/axis.h"
#include "raylab/report/chart/palette.h"
#include "raylab/report/measure.h"

#include <string>
#include <vector>

// An experiment as points on axes: what is drawn where, before anything is drawn.

namespace raylab {

/// A measurement as a marker.
struct Dot {
    std::size_t row;  // of the experiment
    std::string name;  // beside the marker
    double error, time;         // where it is drawn
    double time_low, time_high;
    Look look;
    double size;  // by the number it computes in: float is the smallest
    enum class Kind { error_seen, no_error_seen } kind;
    enum class Place { front, behind } place;
};

/// One workload.
struct TradeoffPanel {
    std::string workload;
    std::vector<Dot> dots;  // those of the front first, by rising error
    std::vector<std::vector<std::size_t>> curves;  // indices of dots: one method swept by its knob, or by its number
};

/// Panels with axes in common.
struct Tradeoffs {
    std::vector<TradeoffPanel> panels;
    std::vector<std::string> numbers;  // from the smallest marker to the largest
    std::vector<std::string> left_out;  // measurements that are no numbers and cannot be drawn
    AxisScale error, time;
};

Tradeoffs tradeoffs_of(const Experiment& experiment);

/// How a method of the experiment looks, in all its panels.
Look look_of(const Experiment& experiment, const std::string& method);

}  // namespace raylab
