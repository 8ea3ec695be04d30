#pragma once

#include "raylab/accelerator/octree/lattice.h"

#include <optional>

namespace raylab {

/// A triangle in a lattice: which cubes of cells it surely does not touch. A cube and a triangle are apart where one of
/// thirteen directions tells them apart: the cube's axes (its box does that), the triangle's normal, and the products
/// of axes and edges. (Akenine-Moeller, Fast 3D Triangle-Box Overlap Testing, JGT 6(1), 2001; with the slack, and what
/// the products' roundings may come to.)
class LatticeTriangle {
public:
    LatticeTriangle(const Lattice& lattice, const Triangle& triangle);

    /// A cube of 2^size cells a side that its box touches.
    bool misses(const LatticeCell& lowest, int size) const;

private:
    using Vector = std::array<double, 3>;
    bool beside(const Vector& center, double half) const;  // some edge's product with an axis says so

    std::array<Vector, 3> corners_, edges_;
    Vector normal_;
    double extent_;
};

/// What an octree is built of: the cells that a primitive's box touches and, to take fewer, the primitive.
struct LatticeShape {
    LatticeRange range;
    std::optional<LatticeTriangle> triangle = {};

    bool misses(const LatticeCell& lowest, int size) const { return triangle && triangle->misses(lowest, size); }
};

}  // namespace raylab
