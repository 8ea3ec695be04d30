#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::shadows {

CaseSketches case_sketches();

}  // namespace raylab::shadows
