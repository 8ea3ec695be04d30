#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::lantern {

CaseSketches case_sketches();

}  // namespace raylab::lantern
