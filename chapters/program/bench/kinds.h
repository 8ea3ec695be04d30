#pragma once

#include "race.h"

#include <string>
#include <vector>

namespace raylab::bench {

/// The table by kinds of meshes: for each kind a line for each peer, geometric means of ratios to embree_high, or to
/// the first peer where that is missing.
std::string kinds_table(const std::vector<Row>& rows);

/// Each structure of raylab that raced against its goals, beside Embree's builds of high and medium quality: a line for
/// each goal, with what was measured. Empty where those did not race.
std::string goals_table(const std::vector<Row>& rows);

}  // namespace raylab::bench
