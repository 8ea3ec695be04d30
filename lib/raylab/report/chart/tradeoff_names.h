#pragma once

#include "raylab/report/chart/sketch.h"
#include "raylab/report/chart/tradeoff_panels.h"

#include <array>

namespace raylab {

/// Which points of a panel are named beside them.
enum class NamedPoints { all, front };

/// Writes the names of a panel's points beside them, inside its frame and never over each other; those of the front are
/// bold. Where there is not room for all, the ends of the front come first and the last ones are left out.
void draw_names(Sketch& sketch, const Rectangle& frame, const TradeoffPanel& panel, const Tradeoffs& all,
                NamedPoints which);

/// The place of a point in a panel's frame.
Point2 place_of(const Dot& dot, const Rectangle& frame, const Tradeoffs& all);

/// The ends of the bar of its times' quartiles.
std::array<Point2, 2> bar_of(const Dot& dot, const Rectangle& frame, const Tradeoffs& all);

}  // namespace raylab
