#pragma once

#include "raylab/accelerator/bvh8/bvh8_parts.h"
#include "raylab/geometry/shapes.h"

#include <cstddef>

namespace raylab::bvh8_parts {

/// Whether a scene is a room, and which of its triangles are the walls: those that lie across an axis and are large
/// parts of the faces of the scene's box. It is a room where walls are at least half of the faces, so that most rays
/// inside of it end at one.
///
/// Walls lie in leaves of their own, at the root. Anywhere else a wall is cut into pieces all over the tree, or makes
/// boxes large that it is in: a ray that asks for any hit then finds the piece in its way as late as the nearest hit.
/// (In `hall_4` such rays that leave surfaces take less than half the time; nearest hits take as long as before.)
class Walls {
public:
    explicit Walls(const Extent& scene = {}) : half_area_(scene.half_area()) {}

    bool has(const Reference& one, const Triangle& triangle) const;
    /// Most primitives are too small to be walls: their triangles need not be looked up.
    bool may_have(const Reference& one) const { return one.is_triangle() && one.box().half_area() >= smallest(); }

    void add(const Triangle& wall);
    void add(const Walls& other);

    /// Of so many primitives. (Where areas underflow or overflow, as many as all may be walls, or none.)
    bool make_a_room(std::size_t primitives) const {
        return count_ > 0 && count_ < primitives && count_ <= most && area_ >= half_area_;
    }

private:
    static constexpr std::size_t most = 64;
    float smallest() const { return half_area_ / 8; }  // half of a quadrangle that is a quarter of two faces

    float half_area_, area_ = 0;
    std::size_t count_ = 0;
};

}  // namespace raylab::bvh8_parts
