#pragma once

#include "race.h"

#include <nlohmann/json_fwd.hpp>

namespace raylab::bench {

/// One JSON row for each mesh, kind of rays, peer and number of threads.
nlohmann::ordered_json to_json(const std::vector<Row>& rows);

/// The table of one mesh: a line for each peer.
std::string mesh_table(const std::vector<Row>& rows);

/// The table over all meshes: geometric means of ratios to the first peer, with which the others are compared.
std::string summary_table(const std::vector<Row>& rows);

}  // namespace raylab::bench
