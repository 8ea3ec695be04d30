#pragma once

#include "raylab/radiosity/mesh/polygonal_model.h"

#include <vector>

namespace raylab {

/// Whether every facet has all others on one side of it, so that none of them stands between two points of others.
/// Asked of at most 1000 facets, as each may have to look at all others; more are never a convex room.
bool is_convex_room(const std::vector<Facet>& facets);

}  // namespace raylab
