#pragma once

#include "raylab/accelerator/painters/plane_side.h"
#include "raylab/geometry/intersect/nearest.h"
#include "raylab/scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace raylab {

/// A general BSP tree of triangles: each node's plane is that of a triangle, and the pieces that it intersects are cut
/// in two. From any eye the pieces can be painted back to front, without comparing depths. (Fuchs, Kedem and Naylor, On
/// Visible Surface Generation by A Priori Tree Structures, SIGGRAPH 1980.)
///
/// A piece is not represented by the polygon that results from rounded cuts, but by its triangle and the sides of the
/// planes by which it was cut: an eye ray hits the triangle exactly, and exactly one of its pieces holds the hit. The
/// rounded corners only bound where a piece may be seen and which planes may cut it, with room for their error.
class PaintersTree {
public:
    /// Throws an Error where a shape is not a triangle, or is transformed.
    explicit PaintersTree(const Scene& scene);

    struct Cut {
        std::uint32_t plane;  // the triangle whose plane it is
        Sign side;
    };
    struct Piece {
        std::uint32_t triangle;
        std::vector<Cut> cuts = {};
        // The hull of these corners, widened by `off`, holds what the cuts left of the triangle.
        std::vector<Vec3d> corners = {};
        double off = 0;
        bool rounded = false;  // on which side of some plane it lies is known only up to rounding
    };
    struct Node {
        std::uint32_t plane;                                    // the triangle whose plane it is
        std::vector<Piece> pieces;                              // those in the plane; the lowest number last
        std::optional<std::uint32_t> behind = {}, before = {};  // indices of nodes
    };
    struct Placed {
        Triangle corners;
        Target target;
        Primitive primitive;
    };

    const std::vector<Node>& nodes() const { return nodes_; }                          // the root first
    const Placed& triangle(std::uint32_t number) const { return triangles_[number]; }  // in scene order
    std::size_t triangles() const { return triangles_.size(); }
    std::size_t pieces() const;
    std::size_t depth() const;

    /// A piece when its turn comes to be painted.
    struct Turn {
        const Piece* piece;
        // Its order is uncertain: rounding hides it, or the eye lies in the plane of a node above, so that rays may run
        // inside that plane.
        bool unordered;
    };
    /// All pieces, the farthest first, for rays that start at `origin`.
    std::vector<Turn> back_to_front(const Vec3f& origin) const;

private:
    std::vector<Placed> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace raylab
