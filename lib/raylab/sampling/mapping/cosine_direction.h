#pragma once

#include "raylab/sampling/mapping/sampled_direction.h"

namespace raylab {

/// The direction of the hemisphere around z that two uniform numbers in [0, 1) stand for, with density cos / pi per
/// steradian: more of them near z, as light counts for more there. This is the slot of exercise 15b.
SampledDirection cosine_direction(double u, double v);

}  // namespace raylab
