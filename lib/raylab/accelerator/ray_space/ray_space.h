#pragma once

#include "raylab/accelerator/primitives.h"
#include "raylab/accelerator/ray_space/ray_cell.h"

#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

struct SortedPrimitives;

/// When a cell of ray space is a leaf.
struct RaySpaceOptions {
    std::size_t few_items = 8;  // items that its rays may hit
    std::size_t few_rays = 1;   // given rays inside it
    int depth = 40;
};

/// Ray-space subdivision: rays with nearby origins and directions share a list of the items that they may hit. Cells
/// are halved in five dimensions. Arvo and Kirk (1987) split the cells where rays arrive while they trace; here the
/// expected rays are given beforehand, so that the structure does not change afterwards. Other rays are answered as
/// well, from larger cells; those outside the space of all given ones are passed to the structure behind it.
class RaySpace final : public Accelerator {
public:
    RaySpace(const Scene& scene, std::span<const Ray> expected, const Accelerator& others,
             const RaySpaceOptions& options = {});

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;  // in addition to those of the structure behind it
    Outline outline() const override { return others_.outline(); }
    std::vector<Visit> visits(const Ray& ray) const override { return others_.visits(ray); }

    std::size_t cells() const { return leaves_.size(); }
    std::size_t items() const { return items_.size(); }  // the number of items in all lists

private:
    struct Item {
        std::uint32_t primitive;
        float depth;  // no ray of the cell hits the item before this depth
    };
    using Items = std::vector<Item>;
    using Points = std::vector<RayPoint>;
    struct Node {
        std::uint32_t axis;   // the axis of the split; is_leaf for a leaf
        std::uint32_t first;  // index of the first of two child nodes, or the number of the leaf
        double cut;
    };
    struct Leaf {
        std::uint32_t first, end;  // a range of items_
    };
    static constexpr std::uint32_t is_leaf = 5;

    RaySpace(const SortedPrimitives& sorted, std::span<const Ray> expected, const Accelerator& others,
             const RaySpaceOptions& options);

    void subdivide(std::size_t node, const RayCell& cell, const Items& items, const Points& points, int depth);
    void make_leaf(std::size_t node, Items items);
    std::size_t widest(const RayCell& cell) const;
    Items within(const RayCell& cell, const Items& items) const;

    /// The items that a ray may hit, the nearest first; absent for a ray outside this space.
    std::optional<std::span<const Item>> items_of(const RayPoint& point, Traversal& traversal) const;

    const Accelerator& others_;
    RaySpaceOptions options_;
    Primitives bounded_, unbounded_;
    std::vector<Box> boxes_;  // needed only during the construction
    double across_ = 0;       // the width of the scene
    std::array<RayCell, 6> roots_{};
    std::vector<Node> nodes_;  // the first six are the roots of the faces
    std::vector<Leaf> leaves_;
    Items items_;
};

}  // namespace raylab
