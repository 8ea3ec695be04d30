#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::grids {

CaseSketches case_sketches();

}  // namespace raylab::grids
