#pragma once

#include "race.h"

#include "raylab/report/structure/structure_growth.h"

namespace raylab::bench {

/// What each peer costs, from the smallest mesh to the largest: nanoseconds a ray are geometric means over the kinds of
/// rays, counts (of our structures) the means.
std::vector<StructureCost> growth(const std::vector<Row>& rows);

/// A line a peer, a column a mesh: rays a second; and for our structures, what a ray visits and tests.
std::string growth_table(const std::vector<StructureCost>& costs);

/// Writes the charts growth_rays, growth_steps, growth_tests, growth_build and growth_bytes.
void write_growth_charts(const std::vector<StructureCost>& costs, const std::filesystem::path& folder);

}  // namespace raylab::bench
