#pragma once

#include "raylab/report/plane/plane_drawing.h"

#include <memory>
#include <string>
#include <vector>

// A general BSP tree on paper: walls in a plane, each of which divides its region along its own line.

namespace raylab::split {

/// A wall; its front is to the left of the way from one end to the other.
struct Wall {
    std::string name;
    PlanePoint from, to;
};

/// A region of the plane: a leaf, or divided along the line of its wall.
struct PlaneTree {
    std::vector<PlanePoint> region;  // convex
    std::vector<Wall> walls = {};    // those in the dividing line; none: a leaf
    std::unique_ptr<PlaneTree> behind = {}, before = {};
};

/// Divides a region by the first of the walls, cuts those that its line goes through, and goes on on both sides.
PlaneTree plane_tree(const std::vector<PlanePoint>& region, const std::vector<Wall>& walls);

/// The leaves in the order in which an eye meets them: front to back.
std::vector<const PlaneTree*> front_to_back(const PlaneTree& tree, PlanePoint eye);

}  // namespace raylab::split
