#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::volumes {

CaseSketches case_sketches();

}  // namespace raylab::volumes
