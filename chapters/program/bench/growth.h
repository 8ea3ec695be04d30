#pragma once

#include "race.h"

#include "raylab/report/structure/structure_growth.h"

namespace raylab::bench {

/// The cost of each peer, from the smallest mesh to the largest: nanoseconds per ray are geometric means over the kinds
/// of rays, counts (of raylab's structures) are arithmetic means.
std::vector<StructureCost> growth(const std::vector<Row>& rows);

/// A table with a line for each peer and a column for each mesh: rays per second, and for raylab's structures the
/// numbers of visits and tests per ray.
std::string growth_table(const std::vector<StructureCost>& costs);

/// Writes the charts growth_rays, growth_steps, growth_tests, growth_build and growth_bytes.
void write_growth_charts(const std::vector<StructureCost>& costs, const std::filesystem::path& folder);

}  // namespace raylab::bench
