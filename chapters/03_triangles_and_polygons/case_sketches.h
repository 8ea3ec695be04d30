#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab {

CaseSketches case_sketches();

}  // namespace raylab
