#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::spread {

CaseSketches case_sketches();

}  // namespace raylab::spread
