#include "raylab/report/decision_trial.h"

namespace raylab {

std::string row_title(const std::string& method, const std::string& workload) { return method + ": " + workload; }

}  // namespace raylab
