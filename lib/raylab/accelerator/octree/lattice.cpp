#include "raylab/accelerator/octree/lattice.h"

#include "raylab/geometry/largest_coordinate.h"

namespace raylab {

namespace {

double largest_extent(const Box& box) {
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, double{box.max[axis]} - box.min[axis]);
    return largest;
}

}  // namespace

Lattice::Lattice(const Box& all) {
    if (all.is_empty()) return;
    // One cell is left between the box and the sides of the cube. For a scene that is a point, the cells are still wide
    // compared with the rounding errors of its coordinates.
    const double extent = std::max({largest_extent(all), largest_coordinate(all) * 0x1p-24, 0x1p-149});
    width_ = extent / (side - 2);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        origin_[axis] = all.min[i] - width_;
        top_[axis] = place(axis, all.max[i]);
    }
}

LatticeRange Lattice::touched(const Box& box) const {
    LatticeRange range{};
    const auto cell = [](double at) { return std::clamp(static_cast<std::int32_t>(std::floor(at)), 0, side - 1); };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        // The slack is taken twice, because these places are rounded, too.
        range.first[axis] = cell(place(axis, box.min[i]) - 2 * slack);
        range.last[axis] = cell(place(axis, box.max[i]) + 2 * slack);
    }
    return range;
}

Box Lattice::box(const LatticeCell& lowest, int size) const {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        box.min[i] = cast<float>(origin_[axis] + lowest[axis] * width_);
        box.max[i] = cast<float>(origin_[axis] + (lowest[axis] + (1 << size)) * width_);
    }
    return box;
}

}  // namespace raylab
