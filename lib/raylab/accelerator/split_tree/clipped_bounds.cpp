#include "raylab/accelerator/split_tree/clipped_bounds.h"

#include "raylab/number/next_float.h"

#include <array>
#include <cmath>

namespace raylab {

namespace {

// A convex polygon: three corners, and at most one more for each of six planes.
struct Corners {
    std::array<Vec3d, 9> at;
    std::size_t count = 0;
    void add(const Vec3d& p) { at[count++] = p; }
};

// The part where direction * x[axis] <= limit (Sutherland and Hodgman, Reentrant Polygon Clipping, CACM 17(1), 1974).
Corners clipped(const Corners& polygon, int axis, double direction, double limit) {
    Corners result;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Vec3d &p = polygon.at[i], &q = polygon.at[(i + 1) % polygon.count];
        const double before = limit - direction * p[axis], after = limit - direction * q[axis];
        if (before >= 0) result.add(p);
        if ((before > 0 && after < 0) || (before < 0 && after > 0))
            result.add(p + (q - p) * (before / (before - after)));
    }
    return result;
}

double largest(const Triangle& t) {
    double result = 0;
    for (const Vec3f& v : {t.a, t.b, t.c})
        for (int axis = 0; axis < 3; ++axis) result = std::max(result, std::abs(double{v[axis]}));
    return result;
}

}  // namespace

Box intersection(const Box& a, const Box& b) {
    Box both;
    for (int axis = 0; axis < 3; ++axis) {
        both.min[axis] = std::max(a.min[axis], b.min[axis]);
        both.max[axis] = std::min(a.max[axis], b.max[axis]);
        if (both.min[axis] > both.max[axis]) return {};
    }
    return both;
}

// Each clipping starts from the polygon as it was computed, so errors add up but are not amplified: a new corner errs
// by at most 12 u M, where M is the largest coordinate, and a polygon that was clipped six times is within 72 u M of
// the exact one. The box is grown by more than that before the clipping, and so is the result.
Box clipped_bounds(const Triangle& triangle, const Box& inside) {
    const double slack = 128 * unit_roundoff<double> * largest(triangle);
    Corners polygon;
    for (const Vec3f& v : {triangle.a, triangle.b, triangle.c}) polygon.add(convert<double>(v));
    for (int axis = 0; axis < 3; ++axis) {
        polygon = clipped(polygon, axis, 1, inside.max[axis] + slack);
        polygon = clipped(polygon, axis, -1, -inside.min[axis] + slack);
    }
    Box box;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            box.min[axis] = std::min(box.min[axis], float_beyond(polygon.at[i][axis] - slack, -1));
            box.max[axis] = std::max(box.max[axis], float_beyond(polygon.at[i][axis] + slack, 1));
        }
    }
    return intersection(box, intersection(inside, bounds(triangle)));
}

}  // namespace raylab
