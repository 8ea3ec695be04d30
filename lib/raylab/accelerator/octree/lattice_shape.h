#pragma once

#include "raylab/accelerator/octree/lattice.h"

#include <optional>

namespace raylab {

/// A triangle in a lattice: it tells which cubes of cells it surely does not touch. A cube and a triangle are disjoint
/// where one of thirteen axes separates them: the cube's axes (tested by the triangle's box), the triangle's normal,
/// and the cross products of axes and edges. (Akenine-Moeller, Fast 3D Triangle-Box Overlap Testing, JGT 6(1), 2001;
/// enlarged by the slack and by a bound of the products' rounding errors.)
class LatticeTriangle {
public:
    LatticeTriangle(const Lattice& lattice, const Triangle& triangle);

    /// Whether the triangle surely misses a cube of 2^size cells along each side that its box touches.
    bool misses(const LatticeCell& lowest, int size) const;

private:
    using Vector = std::array<double, 3>;
    // Whether the cross product of some edge and an axis separates them.
    bool beside(const Vector& center, double half) const;

    std::array<Vector, 3> corners_, edges_;
    Vector normal_;
    double extent_;
};

/// One primitive as an octree is built from it: the cells that its box touches and, to discard some of those, its
/// triangle.
struct LatticeShape {
    LatticeRange range;
    std::optional<LatticeTriangle> triangle = {};

    bool misses(const LatticeCell& lowest, int size) const { return triangle && triangle->misses(lowest, size); }
};

}  // namespace raylab
