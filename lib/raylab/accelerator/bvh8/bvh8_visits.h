#pragma once

#include "raylab/accelerator/bvh8/bvh8_leaves.h"

#include <bit>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace raylab {

/// The boxes of nodes and leaves, for diagrams.
class Bvh8Boxes {
public:
    Box& operator[](Bvh8Child child) { return boxes_[std::bit_cast<std::uint32_t>(child)]; }
    const Box& at(Bvh8Child child) const { return boxes_.at(std::bit_cast<std::uint32_t>(child)); }

private:
    std::map<std::uint32_t, Box> boxes_;
};

/// Records the nodes and leaves that a traversal visits.
class Bvh8Visits final : public NearestLeaves {
public:
    Bvh8Visits(const Bvh8Contents& contents, Bvh8Boxes boxes, const Ray& ray, Traversal& traversal)
        : NearestLeaves(contents, ray, traversal), boxes_(std::move(boxes)) {}

    void came_to(Bvh8Child child) override {
        const Visit::Kind kind = child.is_node() ? Visit::Kind::inner : Visit::Kind::leaf;
        visits_.push_back({boxes_.at(child), kind, child.is_node() ? 0 : child.count()});
    }

    std::vector<Visit> visits() const { return visits_; }

private:
    Bvh8Boxes boxes_;
    std::vector<Visit> visits_;
};

}  // namespace raylab
