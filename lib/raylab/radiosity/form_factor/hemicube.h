#pragma once

#include "raylab/geometry/vector.h"

#include <array>
#include <span>
#include <vector>

// The hemicube (Cohen and Greenberg, "The Hemi-Cube: A Radiosity Solution for Complex Environments", SIGGRAPH 85): half
// a cube around a patch's centre, whose pixels each stand for a share of what the patch sends out. Weak spots: a
// polygon nearer than five times the patch's size, of which the centre sees more or less than the patch; a polygon of
// the size of a pixel.

namespace raylab {

/// One face of a hemicube with what its pixels see. Row 0 is the top row.
struct HemicubeFace {
    int columns, rows;
    std::vector<int> nearest;           // the index of the nearest polygon, or nothing_seen
    std::vector<double> delta_factors;  // the form factor from the centre to each pixel, as Cohen and Greenberg give it

    static constexpr int nothing_seen = -1;
};

/// The faces: the one along the normal, and those to the right, up, left and down. The latter are cut in half: the
/// normal is towards their row 0.
struct Hemicube {
    std::array<HemicubeFace, 5> faces;
};

/// What is seen from a point through a hemicube of resolution x resolution pixels (an even number). The normal and `up`
/// are of length 1 and at right angles. Each pixel is decided by the ray through its middle: the nearest polygon is
/// that of the least distance in doubles, without a depth buffer's steps, and of equal ones the first. A polygon is a
/// side of a surface; seen from behind it is not there.
Hemicube hemicube(const Vec3d& point, const Vec3d& normal, const Vec3d& up,
                  std::span<const std::span<const Vec3d>> polygons, int resolution);

/// Delta factors sum to 1 only as the resolution grows; the error falls with its square.
enum class DeltaFactors { raw, normalised };

/// The form factor from the point to each of `polygons` polygons.
std::vector<double> form_factor_row(const Hemicube& hemicube, std::size_t polygons, DeltaFactors factors);

}  // namespace raylab
