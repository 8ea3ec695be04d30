#include "raylab/report/decision_trial.h"

#include <fmt/format.h>

namespace raylab {

std::string row_title(const std::string& method, const std::string& workload) { return method + ": " + workload; }

std::string percent(double share) { return fmt::format("{:g} %", 100 * share); }

}  // namespace raylab
