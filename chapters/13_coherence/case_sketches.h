#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::coherence {

CaseSketches case_sketches();

}  // namespace raylab::coherence
