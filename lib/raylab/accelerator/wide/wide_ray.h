#pragma once

#include "raylab/geometry/box.h"
#include "raylab/geometry/ray.h"

#include <array>
#include <cstddef>

namespace raylab {

/// A ray prepared for eight boxes, or eight triangles, at once, in floats.
///
/// Boxes: a ray never misses one that it exactly meets. t = (plane - origin) * (1 / direction) has three roundings: 4 u |t|.
/// The far planes' t is made larger by twice that and a little more, by way of the inverse (Ize: Robust BVH Ray Traversal,
/// JCGT 2(2), 2013), which is right where no t in the ray's range is negative. And the origin is moved outward by one float
/// for either plane: that makes up for products that underflow, and a ray along an axis, whose direction is zero on the
/// other two, never multiplies zero by infinity: its inverse is so large a number that one float's distance is far beyond
/// all that matters.
///
/// Triangles: sheared along the ray's dominant axis (Woop, Benthin & Wald: Watertight Ray/Triangle Intersection, JCGT 2(1),
/// 2013) a triangle is hit where the three areas about the origin have one sign. A bound of their rounding errors, with the
/// part that depends on the ray alone computed once, says which signs are sure: see wide_walk.cpp.
struct WideRay {
    /// `bounds`: of all the triangles that the ray may be asked about.
    WideRay(const Ray& ray, const Box& bounds);

    /// Nothing beyond t matters.
    void set_end(double t);

    /// Whether floats will do: coordinates below 2^60, directions between 2^-60 and 2^40 or zero, no negative t.
    bool tame;

    std::array<std::size_t, 3> near_plane, far_plane;      // of each axis, as WideNode has them
    std::array<float, 3> near_origin, far_origin;          // moved outward
    std::array<float, 3> near_inverse, far_inverse;
    float start, end = 0;

    std::array<std::size_t, 3> axes;  // the two the triangles are sheared in, and the dominant one
    std::array<float, 3> origin, direction;  // along those
    std::array<float, 2> shear;       // direction along the first two, by that along the dominant one
    /// How wrong an area may be: constant + r (linear + quadratic r), r the largest sheared coordinate of the triangle.
    float error_constant, error_linear, error_quadratic;

    static constexpr float largest = 0x1p60f, flattest = 0x1p-60f, steepest = 0x1p40f;
};

}  // namespace raylab
