#pragma once

#include "raylab/geometry/vector.h"

#include <array>
#include <functional>

namespace raylab {

/// Where a ray hits a triangle whose vertices have normals.
struct InterpolatedHit {
    std::array<Vec3d, 3> normals;  // unit, one a vertex
    Vec3d face;                    // unit: the triangle's own
    double u, v;                   // the weights of the second and the third vertex; the first has the rest
    Vec3d to_viewer;               // from the hit to the eye, not necessarily unit
};

/// The brightness that the local model gives a point with this unit normal.
using BrightnessOf = std::function<double(const Vec3d& unit_normal)>;

struct InterpolatedBrightness {
    double gouraud, phong;
};

/// The brightness of a hit by both interpolations: Gouraud's mixes the brightness of the vertices, Phong's their
/// normals, which are made unit again. A triangle that is seen from behind has all its normals the other way round.
/// Where the mixed normal is zero, the triangle's own stands in. (H. Gouraud: Continuous Shading of Curved Surfaces,
/// 1971; Bui Tuong Phong: Illumination for Computer Generated Pictures, 1975.)
InterpolatedBrightness gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness);

}  // namespace raylab
