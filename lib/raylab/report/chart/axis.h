#pragma once

#include "raylab/report/chart/chart.h"

#include <string>
#include <vector>

namespace raylab {

struct Tick {
    double at;
    std::string text;
};

/// A chart's axis: the range it spans and its marks.
struct AxisScale {
    AxisKind kind = AxisKind::linear;
    double low = 0, high = 1;
    std::vector<Tick> ticks;

    /// The position of a value: 0 at the low end, 1 at the high end.
    double share(double value) const;
    /// The value at a position: the inverse of share().
    double value(double share) const;
};

/// An axis that holds all the values, with `margin` of its length free at both ends. Values that are not finite, or not
/// positive on a logarithmic axis, are left out.
AxisScale axis_for(const std::vector<double>& values, AxisKind kind, double margin);

/// The axis's marks, if their texts fit side by side in `length` pixels; otherwise only the powers of ten, or every
/// other one.
std::vector<Tick> marks_with_room(const AxisScale& scale, double length, double font_size);

/// "1", "50", "1 000", "10⁵", "0.1", "10⁻⁶".
std::string power_text(double value);

}  // namespace raylab
