#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::cornell {

CaseSketches case_sketches();

}  // namespace raylab::cornell
