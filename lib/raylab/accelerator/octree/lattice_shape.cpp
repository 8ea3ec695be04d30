#include "raylab/accelerator/octree/lattice_shape.h"

namespace raylab {

namespace {

// A cube's half side is enlarged by the slack, and by the rounding errors of the corners.
constexpr double more = 2 * Lattice::slack;

// Bounds of the rounding errors below, with 2^16 cells along a side and edges of at most e cells: a product of two
// edges errs by less than 2^-50 e^2, that times a distance of less than 2^17 by less than 2^-31 e^2; an edge times a
// distance by less than 2^-34 e.
constexpr double normal_error = 0x1p-31, edge_error = 0x1p-34;

}  // namespace

LatticeTriangle::LatticeTriangle(const Lattice& lattice, const Triangle& triangle) : extent_(0) {
    const std::array corners{triangle.a, triangle.b, triangle.c};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            corners_[i][axis] = lattice.place(axis, corners[i][static_cast<int>(axis)]);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            edges_[i][axis] = corners_[(i + 1) % 3][axis] - corners_[i][axis];
            extent_ = std::max(extent_, std::abs(edges_[i][axis]));
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
        normal_[axis] = edges_[0][y] * edges_[1][z] - edges_[0][z] * edges_[1][y];
    }
}

bool LatticeTriangle::misses(const LatticeCell& lowest, int size) const {
    const double half = 0.5 * (1 << size);
    Vector center{};
    double distance = 0, reach = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        center[axis] = lowest[axis] + half;
        distance += normal_[axis] * (corners_[0][axis] - center[axis]);
        reach += std::abs(normal_[axis]) * (half + more);
    }
    return std::abs(distance) > reach + normal_error * extent_ * extent_ || beside(center, half + more);
}

bool LatticeTriangle::beside(const Vector& center, double half) const {
    const double error = edge_error * extent_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector& edge = edges_[i];
            const auto along = [&](const Vector& p) {
                return edge[y] * (p[z] - center[z]) - edge[z] * (p[y] - center[y]);
            };
            const double on_edge = along(corners_[i]), opposite = along(corners_[(i + 2) % 3]);
            const double reach = half * (std::abs(edge[y]) + std::abs(edge[z])) + error;
            if (std::min(on_edge, opposite) > reach || std::max(on_edge, opposite) < -reach) return true;
        }
    }
    return false;
}

}  // namespace raylab
