#pragma once

#include "raylab/geometry/vector.h"

#include <span>
#include <vector>

namespace raylab {

/// Maps the unit square to a convex polygon so that equal areas stay equal: a uniform point becomes a uniform point. A
/// parallelogram is mapped linearly, and any other polygon triangle by triangle.
class UniformPoints {
public:
    explicit UniformPoints(std::span<const Vec3d> polygon);

    double area() const { return area_; }
    Vec3d at(double u, double v) const;

private:
    struct Triangle {
        Vec3d corner, first_side, second_side;
        double area;
    };

    std::vector<Triangle> fan_;
    bool parallelogram_;
    double area_ = 0;
};

}  // namespace raylab
