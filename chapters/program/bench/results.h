#pragma once

#include "race.h"

#include <nlohmann/json_fwd.hpp>

namespace raylab::bench {

/// One row a mesh, kind of rays, peer and number of threads.
nlohmann::ordered_json to_json(const std::vector<Row>& rows);

/// Of one mesh: a line a peer.
std::string mesh_table(const std::vector<Row>& rows);

/// Over all meshes: geometric means of ratios to the first peer, which is the measure of the others.
std::string summary_table(const std::vector<Row>& rows);

}  // namespace raylab::bench
