#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::octrees {

CaseSketches case_sketches();

}  // namespace raylab::octrees
