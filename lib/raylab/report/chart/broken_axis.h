#pragma once

#include "raylab/report/chart/axis.h"

#include <optional>
#include <vector>

namespace raylab {

/// A logarithmic axis that is broken where few values are far above all others, so that those keep their room.
struct BrokenAxis {
    AxisScale main;
    std::optional<AxisScale> beyond;  // the part above the break

    static constexpr double main_share = 0.84, gap_share = 0.04;  // of a broken axis: its main part, the break

    /// Its parts, the one beyond the break last.
    std::vector<const AxisScale*> scales() const;
    /// The position of a value: 0 at the low end, 1 at the high end.
    double share(double value) const;
};

/// The axis of some values. It is broken at their widest gap if that spans more than a third of the axis and a decade,
/// and at most one value of five is above it. `margin` of the length of its main part is free at both ends.
BrokenAxis broken_axis_for(std::vector<double> values, double margin);

}  // namespace raylab
