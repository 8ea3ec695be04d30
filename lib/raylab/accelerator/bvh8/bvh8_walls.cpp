#include "raylab/accelerator/bvh8/bvh8_walls.h"

namespace raylab::bvh8_parts {

bool Walls::has(const Reference& one, const Triangle& triangle) const {
    const float own = area(triangle);
    // The box of half a rectangle that lies across an axis has twice its area.
    return own >= smallest() && one.box().half_area() <= 3 * own;
}

void Walls::add(const Triangle& wall) {
    area_ += area(wall);
    ++count_;
}

void Walls::add(const Walls& other) {
    area_ += other.area_;
    count_ += other.count_;
}

}  // namespace raylab::bvh8_parts
