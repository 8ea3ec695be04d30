#pragma once

#include "raylab/accelerator/primitives.h"
#include "raylab/geometry/filter/sphere_filter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// Up to 32 shapes, their numbers in rows, which a ray is asked about together, in doubles: spheres by their equation,
/// all others by the boxes around them.
struct alignas(64) ShapeRows {
    static constexpr std::size_t largest = 32;
    using Row = std::array<double, largest>;

    struct Spheres {
        Row x{}, y{}, z{}, squared_radius{};
    } spheres;
    std::array<Row, 3> lower{}, upper{};  // of boxes, enlarged for rounding (see row_boxes-inl.h)
    std::size_t sphere_count = 0, box_count = 0;

    std::array<std::uint32_t, largest> numbers{};  // which primitive stands at a place: spheres first, then boxes

    sphere_filter::Ball ball(std::size_t place) const {
        return {{spheres.x[place], spheres.y[place], spheres.z[place]}, spheres.squared_radius[place]};
    }
    std::size_t size() const { return sphere_count + box_count; }
};

/// All primitives.
std::vector<ShapeRows> in_rows(const Primitives& primitives);

}  // namespace raylab
