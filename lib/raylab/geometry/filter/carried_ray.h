#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/ray.h"

#include <array>
#include <optional>

namespace raylab {

/// A ray in the coordinates that a placed shape is given in, its origin as seen from a point of the shape. In doubles:
/// origin and direction are each wrong by no more than `off` of their own length. t is what it was.
struct CarriedRay {
    static constexpr double off = 0x1p-42;
    Vec3d origin, direction;
    Interval<float> range;
};

/// What carries rays back to where a shape was made, before a placement moved it: the inverse of that, computed once.
class CarryBack {
public:
    explicit CarryBack(const Affine& placement);

    /// Absent: too much cancels. So it is where the ray starts much nearer to the point than to where the placement
    /// moves the shape's own origin (a rotation: 1/80 as near), or where the placement is nearly flat.
    std::optional<CarriedRay> operator()(const Ray& ray, const Vec3d& from) const;

private:
    std::array<Vec3d, 3> rows_;  // of the inverse of the linear part
    Vec3d translation_;
    double squared_loss_;  // so much longer a vector may at most be, squared, than what becomes of it
};

}  // namespace raylab
