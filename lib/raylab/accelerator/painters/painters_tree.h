#pragma once

#include "raylab/accelerator/painters/plane_side.h"
#include "raylab/geometry/nearest.h"
#include "raylab/scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace raylab {

/// A general BSP tree of triangles: each node's plane is a triangle's own, and what it goes through is cut in two. From
/// any eye the pieces can be painted back to front, without comparing depths. (Fuchs, Kedem and Naylor, On Visible
/// Surface Generation by A Priori Tree Structures, SIGGRAPH 1980.)
///
/// A piece is not the polygon that rounding makes of a cut, but its triangle and the sides of the planes it was cut by:
/// an eye ray hits the triangle exactly, and exactly one of its pieces holds the hit. The rounded corners only say
/// where a piece may be seen, and which planes may cut it, with room for their error.
class PaintersTree {
public:
    /// Error where something is not a triangle that stands where it was made.
    explicit PaintersTree(const Scene& scene);

    struct Cut {
        std::uint32_t plane;  // the triangle's
        Sign side;
    };
    struct Piece {
        std::uint32_t triangle;
        std::vector<Cut> cuts = {};
        std::vector<Vec3d> corners = {};  // what the cuts left of it lies within `off` of their hull
        double off = 0;
        bool rounded = false;  // which side of some plane it lies on is only known but for rounding
    };
    struct Node {
        std::uint32_t plane;                                    // the triangle's
        std::vector<Piece> pieces;                              // those in the plane; the lowest last
        std::optional<std::uint32_t> behind = {}, before = {};  // nodes
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

    /// A piece as its turn comes to be painted.
    struct Turn {
        const Piece* piece;
        bool unordered;  // rounding hides its order, or the eye lies in the plane of a node above: rays may go along it
    };
    /// All pieces, the farthest first, for rays that start at `origin`.
    std::vector<Turn> back_to_front(const Vec3f& origin) const;

private:
    std::vector<Placed> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace raylab
