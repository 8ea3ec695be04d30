#pragma once

#include "raylab/report/case_sketch.h"

namespace raylab::ray_generation {

CaseSketches case_sketches();

}  // namespace raylab::ray_generation
