#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::split {

CaseSketches case_sketches();

}  // namespace raylab::split
