#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::transforms {

CaseSketches case_sketches();

}  // namespace raylab::transforms
