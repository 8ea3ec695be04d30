#pragma once

#include "walks.h"

#include "raylab/report/stability.h"

namespace raylab::grids {

/// The cells around the lost one, seen along the axis that matters least.
CaseExample example_of(const LostCell& lost, const CubeOfCells& cube);

}  // namespace raylab::grids
