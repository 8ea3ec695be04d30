#pragma once

#include "raylab/report/chart/chart.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

// A chart of curves as data.

namespace raylab {

/// One CSV record for each point: curve, x, y, low, high.
std::string to_csv(const CurveChart& chart);
nlohmann::ordered_json to_json(const CurveChart& chart);

}  // namespace raylab
