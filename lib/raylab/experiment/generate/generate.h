#pragma once

#include "raylab/geometry/shapes.h"

// Closed meshes made by rule, for workloads, tests, and where the real meshes are missing. Their outside is where the
// normals of their triangles point. They are computed in double from +, -, *, / and square roots alone, which every
// machine rounds alike, and then rounded to floats: the same bits everywhere.

namespace raylab {

/// The unit sphere from an icosahedron whose triangles are split in four `levels` times: 20 * 4^levels triangles.
Mesh icosphere(int levels);

/// Around the z axis; a circle of radius `tube` whose centre runs on one of radius 1. 2^(2 levels + 1) triangles, and
/// so levels >= 2.
Mesh torus(double tube, int levels);

/// A sphere with dents and bumps: the icosphere's vertices v moved out to 1 + height T(x) T(y) T(z), with T Chebyshev's
/// polynomial of degree `bumps`. |height| < 1.
Mesh bumpy_sphere(int levels, double height = 0.15, int bumps = 6);

/// A tube along the trefoil knot (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t), within 4 of the origin: it hides and
/// shadows itself. tube <= 0.5. 2^(2 levels + 1) triangles, sixteen rings for each point of a ring, and so levels >= 4.
Mesh trefoil_knot(double tube, int levels);

}  // namespace raylab
