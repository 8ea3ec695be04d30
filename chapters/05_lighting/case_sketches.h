#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::lighting {

CaseSketches case_sketches();

}  // namespace raylab::lighting
