#include "raylab/accelerator/shape_rows/shape_rows.h"

#include <cmath>

namespace raylab {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Box everything{Vec3f{-infinity, -infinity, -infinity}, Vec3f{infinity, infinity, infinity}};

void add(ShapeRows& to, const Sphere& sphere) {
    const std::size_t i = to.sphere_count++;
    to.spheres.x[i] = sphere.center.x;
    to.spheres.y[i] = sphere.center.y;
    to.spheres.z[i] = sphere.center.z;
    to.spheres.squared_radius[i] = double{sphere.radius} * sphere.radius;
}

// Eight roundings, and 2^-300 where a coordinate is zero: smaller than any distance of floats, see row_boxes-inl.h.
double margin(double x) { return std::isinf(x) ? 0 : std::abs(x) * 0x1p-49 + 0x1p-300; }

void add(ShapeRows& to, const Box& box) {
    const std::size_t i = to.box_count++;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double lower = box.min[static_cast<int>(axis)], upper = box.max[static_cast<int>(axis)];
        to.lower[axis][i] = lower - margin(lower);
        to.upper[axis][i] = upper + margin(upper);
    }
}

template <class Shape>
void add(std::vector<ShapeRows>& to, const Shape& shape, std::uint32_t number) {
    if (to.empty() || to.back().size() == ShapeRows::largest) to.emplace_back();
    to.back().numbers[to.back().size()] = number;
    add(to.back(), shape);
}

}  // namespace

std::vector<ShapeRows> in_rows(const Primitives& primitives) {
    std::vector<ShapeRows> rows;
    const auto count = static_cast<std::uint32_t>(primitives.size());
    for (std::uint32_t i = 0; i < count; ++i)
        if (const auto sphere = primitives.whole_sphere(i)) add(rows, *sphere, i);
    for (std::uint32_t i = 0; i < count; ++i)  // the spheres are all there
        if (!primitives.whole_sphere(i)) add(rows, primitives.bounds(i).value_or(everything), i);
    return rows;
}

}  // namespace raylab
