#pragma once

#include "raylab/report/chart/chart.h"

#include <string>
#include <vector>

namespace raylab {

struct Tick {
    double at;
    std::string text;
};

/// A chart's axis: what it spans and where it is marked.
struct AxisScale {
    AxisKind kind = AxisKind::linear;
    double low = 0, high = 1;
    std::vector<Tick> ticks;

    /// Where a value stands: 0 at the low end, 1 at the high one.
    double share(double value) const;
    /// The value that stands there.
    double value(double share) const;
};

/// An axis that holds all the values (those not finite, or not positive on a logarithmic one, left out) with `margin`
/// of its length free at both ends.
AxisScale axis_for(const std::vector<double>& values, AxisKind kind, double margin);

/// Its marks where `length` pixels hold their texts side by side; otherwise only the powers of ten, or every other one.
std::vector<Tick> marks_with_room(const AxisScale& scale, double length, double font_size);

/// "1", "50", "1 000", "10⁵", "0.1", "10⁻⁶".
std::string power_text(double value);

}  // namespace raylab
