#pragma once

#include "raylab/radiosity/mesh/polygonal_model.h"

namespace raylab {

/// Cuts facets along the lines on which another polygon stands on them or goes through them. There the light jumps (a
/// discontinuity of degree 0: Heckbert, Discontinuity Meshing for Radiosity, Eurographics Workshop on Rendering 1992):
/// a patch that reaches under a wall shows some of the light before it behind it. A facet is cut from end to end, and
/// vertices are not shared across a cut.
PolygonalModel with_contact_lines(PolygonalModel model);

}  // namespace raylab
