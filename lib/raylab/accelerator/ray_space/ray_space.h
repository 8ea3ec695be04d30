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
    std::size_t few_items = 8;  // may be met in it
    std::size_t few_rays = 1;   // of those it is built for lie in it
    int depth = 40;
};

/// Ray-space subdivision: rays that begin nearby and go nearly the same way share a list of what they may meet. Cells are
/// cut in halves in five dimensions. Arvo and Kirk (1987) cut where rays come while they trace; here the rays to expect are
/// given beforehand, so that nothing changes afterwards. Other rays are answered as well, from larger cells; those outside
/// the space of all given ones, by the structure behind.
class RaySpace final : public Accelerator {
public:
    RaySpace(const Scene& scene, std::span<const Ray> expected, const Accelerator& others, const RaySpaceOptions& options = {});

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;  // beyond those of the structure behind it
    Outline outline() const override { return others_.outline(); }
    std::vector<Visit> visits(const Ray& ray) const override { return others_.visits(ray); }

    std::size_t cells() const { return leaves_.size(); }
    std::size_t items() const { return items_.size(); }  // of all lists

private:
    struct Item {
        std::uint32_t primitive;
        float depth;  // no ray of the cell meets it before
    };
    using Items = std::vector<Item>;
    using Points = std::vector<RayPoint>;
    struct Node {
        std::uint32_t axis;   // of the cut; is_leaf: none
        std::uint32_t first;  // of two nodes; a leaf's number
        double cut;
    };
    struct Leaf {
        std::uint32_t first, end;  // in items_
    };
    static constexpr std::uint32_t is_leaf = 5;

    RaySpace(const SortedPrimitives& sorted, std::span<const Ray> expected, const Accelerator& others,
             const RaySpaceOptions& options);

    void subdivide(std::size_t node, const RayCell& cell, const Items& items, const Points& points, int depth);
    void make_leaf(std::size_t node, Items items);
    std::size_t widest(const RayCell& cell) const;
    Items within(const RayCell& cell, const Items& items) const;

    /// The items that a ray may meet, the nearest first; absent: the ray is none of this space.
    std::optional<std::span<const Item>> items_of(const RayPoint& point, Traversal& traversal) const;

    const Accelerator& others_;
    RaySpaceOptions options_;
    Primitives bounded_, unbounded_;
    std::vector<Box> boxes_;  // while it is built
    double across_ = 0;       // how wide the scene is
    std::array<RayCell, 6> roots_{};
    std::vector<Node> nodes_;  // the first six are the faces' roots
    std::vector<Leaf> leaves_;
    Items items_;
};

}  // namespace raylab
