#pragma once

#include "race.h"

#include "raylab/experiment/measure/measure.h"

namespace raylab::bench {

/// Error against speed: for each peer the wrong hit decisions of a million rays that are aimed at vertices and edges
/// (most are leaks) against its time for a ray of the other sets (geometric mean over meshes and rays). Without rows of
/// aimed rays it has no points.
Experiment error_against_speed(const std::vector<Row>& rows);

}  // namespace raylab::bench
