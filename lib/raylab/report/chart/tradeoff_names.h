#pragma once

#include "raylab/report/chart/gnuplot_canvas.h"
#include "raylab/report/chart/tradeoff_panels.h"

#include <string>

namespace raylab {

struct NameStyle {
    double font;
    enum class Which { all, front } which;
};

/// The names of a panel's points, beside them, inside the panel and never over each other; those of the front are bold.
/// Where there is not room for all, the ends of the front come first and the last ones are left out.
std::string tradeoff_names(const Canvas& canvas, const Rectangle& area, const TradeoffPanel& panel,
                           const Tradeoffs& all, const NameStyle& style);

}  // namespace raylab
