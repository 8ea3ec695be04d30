#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::recursion {

CaseSketches case_sketches();

}  // namespace raylab::recursion
