#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chart/broken_axis.h"
#include "raylab/report/chart/palette.h"

#include <string>
#include <vector>

// An experiment as points on axes: what is drawn and where, before anything is drawn.

namespace raylab {

/// A measurement as a marker.
struct Dot {
    std::size_t row;               // index in the experiment
    std::string name;              // the text beside the marker
    double error, time;            // where it is drawn
    double error_low, error_high;  // `error` twice, where no interval is known
    double time_low, time_high;
    MarkerStyle look;
    double size;  // by the number type it computes in: float is the smallest
    enum class Kind { error_seen, no_error_seen } kind;
    enum class Place { front, behind } place;
};

/// The points of one workload.
struct TradeoffPanel {
    std::string workload;
    std::vector<Dot> dots;  // those of the front first, by rising error
    // Indices of dots: one method with varying knob, or varying number type.
    std::vector<std::vector<std::size_t>> curves;
};

/// Panels with common axes.
struct Tradeoffs {
    std::vector<TradeoffPanel> panels;
    std::vector<std::string> numbers;   // number types from the smallest marker to the largest
    std::vector<std::string> left_out;  // measurements without a number, which cannot be drawn
    BrokenAxis error, time;
};

Tradeoffs tradeoffs_of(const Experiment& experiment);

/// The look of a method of the experiment, the same in all its panels.
MarkerStyle style_of(const Experiment& experiment, const std::string& method);

}  // namespace raylab
