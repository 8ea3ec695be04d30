#include "raylab/accelerator/wide/wide_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

constexpr float unit = std::numeric_limits<float>::epsilon() / 2;  // u
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float largest_float = std::numeric_limits<float>::max();

// One float further, or 2^-100 from zero, which no product with an inverse loses.
float above(float x) { return x + std::max(std::abs(x) * (2 * unit), 0x1p-100f); }
float below(float x) { return -above(-x); }

}  // namespace

WideRay::WideRay(const Ray& ray, const Box& bounds) : start(ray.range.min) {
    tame = start >= 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        const float o = ray.origin[axis], d = ray.direction[axis], steep = std::abs(d);
        tame = tame && std::abs(o) <= largest && (d == 0 || (steep >= flattest && steep <= steepest));
        const float inverse = d == 0 ? 0x1p126f : 1 / d;
        const bool backward = inverse < 0;
        near_plane[i] = backward ? i + 3 : i;
        far_plane[i] = backward ? i : i + 3;
        near_origin[i] = backward ? below(o) : above(o);
        far_origin[i] = backward ? above(o) : below(o);
        near_inverse[i] = inverse;
        far_inverse[i] = inverse * (1 + 12 * unit);
    }
    set_end(ray.range.max);

    const float x = std::abs(ray.direction.x), y = std::abs(ray.direction.y), z = std::abs(ray.direction.z);
    const std::size_t dominant = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    axes = {(dominant + 1) % 3, (dominant + 2) % 3, dominant};
    std::array<float, 3> reach;  // at least how far any corner is from the origin, on each axis
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(axes[i]);
        origin[i] = ray.origin[axis];
        direction[i] = ray.direction[axis];
        reach[i] = std::max(std::abs(bounds.min[axis] - origin[i]), std::abs(bounds.max[axis] - origin[i]));
    }
    float coordinate_error = 0;  // of a sheared coordinate, both axes together
    for (std::size_t i = 0; i < 2; ++i) {
        shear[i] = ray.direction[static_cast<int>(axes[i])] * near_inverse[dominant];
        // x' = (a_x - o_x) - s (a_z - o_z): one rounding of the first term, four of the second (s has two), one of x'.
        coordinate_error += unit * (2 * reach[i] + 5 * std::abs(shear[i]) * reach[2]) * (1 + 0x1p-10f) + 0x1p-140f;
    }
    // U = c_x b_y - c_y b_x: each coordinate is wrong by up to e_x or e_y and no larger than r, each product and the difference
    // is rounded: 2 r (e_x + e_y) + 2 e_x e_y + 4 u r^2, and a thousandth for the bound's own roundings.
    constexpr float spare = 1 + 0x1p-10f;
    error_linear = 2 * coordinate_error * spare;
    error_constant = coordinate_error * coordinate_error * spare + 0x1p-140f;  // >= 2 e_x e_y
    error_quadratic = 4 * unit * spare;
    if (!(reach[0] <= steepest && reach[1] <= steepest && reach[2] <= steepest)) error_constant = infinity;  // all are doubtful
}

void WideRay::set_end(double t) {
    // Rounded up (two roundings), and finite: a box met at infinity only is not met.
    end = !(t < largest_float) ? largest_float : t > -largest_float ? cast<float>(t + 2 * unit * std::abs(t)) : -infinity;
}

}  // namespace raylab
