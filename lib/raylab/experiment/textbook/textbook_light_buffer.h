#pragma once

#include "raylab/accelerator/light_buffer/light_cell.h"
#include "raylab/accelerator/primitives.h"

#include <cstdint>
#include <vector>

namespace raylab {

/// A light buffer as it was published (Haines and Greenberg 1986): filled by listed_cells(), asked by light_cell() and
/// searched by light_through_list(), in doubles and without any error bound, for the scene's first light. What is no
/// polygon is listed by the sides of its box. Rays that do not end at this light are tested against everything.
class TextbookLightBuffer final : public Accelerator {
public:
    TextbookLightBuffer(const Scene& scene, int resolution);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;

private:
    struct Entry {
        double depth;  // along the face's axis, from the light; nothing of the primitive is less deep
        std::uint32_t primitive;
    };
    using List = std::vector<Entry>;

    std::size_t index(const LightCell& cell) const;
    void add(std::uint32_t primitive);

    Primitives primitives_;
    Vec3d light_;
    int resolution_;
    std::vector<List> lists_;  // one a cell, sorted by depth
    std::vector<std::uint32_t> unbounded_;
};

}  // namespace raylab
