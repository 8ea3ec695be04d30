#pragma once

#include "raylab/geometry/vector.h"

#include <array>

namespace raylab {

/// The pyramid of directions from a light through a rectangle of a face of its cube: a cell, or 2 x 2, 4 x 4, ... of
/// them up to the whole face. The rectangle is [u_min, u_max] x [v_min, v_max] at depth 1 along the face's axis; its
/// numbers are exact for any resolution that is a power of two.
struct LightPyramid {
    int face;
    double u_min = -1, u_max = 1, v_min = -1, v_max = 1;

    int axis() const { return face / 2; }
    double sign() const { return face % 2 == 0 ? 1 : -1; }

    /// The vector u, v along the face, w along its axis: outward.
    Vec3d vector(double u, double v, double w) const {
        Vec3d result{0};
        result[axis()] = sign() * w;
        result[(axis() + 1) % 3] = u;
        result[(axis() + 2) % 3] = v;
        return result;
    }
    double depth(const Vec3d& p) const { return sign() * p[axis()]; }

    std::array<Vec3d, 4> corners() const {
        return {vector(u_min, v_min, 1), vector(u_max, v_min, 1), vector(u_max, v_max, 1), vector(u_min, v_max, 1)};
    }
    Vec3d center() const { return vector((u_min + u_max) / 2, (v_min + v_max) / 2, 1); }

    /// The normals of its sides, outward, and of the plane behind it: n . corner <= 0 for each, computed exactly.
    std::array<Vec3d, 5> outward() const {
        return {vector(-1, 0, u_min), vector(1, 0, -u_max), vector(0, -1, v_min), vector(0, 1, -v_max),
                vector(0, 0, -1)};
    }

    std::array<LightPyramid, 4> quarters() const {
        const double u = (u_min + u_max) / 2, v = (v_min + v_max) / 2;
        return {LightPyramid{face, u_min, u, v_min, v}, LightPyramid{face, u, u_max, v_min, v},
                LightPyramid{face, u_min, u, v, v_max}, LightPyramid{face, u, u_max, v, v_max}};
    }
};

}  // namespace raylab
