#pragma once

#include "raylab/geometry/affine.h"

#include <array>

namespace raylab {

/// The moment's placement of a shape that moves, M(t) = M + t R, in numbers of any kind: exact ones hold it exactly,
/// because M, R and t are floats.
template <Scalar T>
struct PlacementAt {
    std::array<Vec3<T>, 3> columns;  // of the linear part
    Vec3<T> translation;
};

template <Scalar T>
PlacementAt<T> placement_at(const Affine& placement, const Motion& motion, float time) {
    const T t(time);
    const auto at = [&](const Vec3f& begin, const Vec3f& rate) {
        return Vec3<T>(convert<T>(begin) + t * convert<T>(rate));
    };
    const auto& m = placement.columns;
    const auto& r = motion.columns;
    return {{at(m[0], r[0]), at(m[1], r[1]), at(m[2], r[2])}, at(placement.translation, motion.translation)};
}

/// The same rounded to floats, where that is good enough.
inline Affine rounded_placement(const Affine& placement, const Motion& motion, float time) {
    const auto [columns, translation] = placement_at<double>(placement, motion, time);
    return AffineSteps{columns, translation}.rounded();
}

/// True if a shape keeps its size and its directions while it moves.
inline bool only_translates(const Motion& motion) { return motion.columns == Motion{}.columns; }

/// True if nothing but a translation is ever between the shape as it was given and its place.
inline bool only_translates(const Affine& placement, const Motion& motion) {
    return only_translates(motion) && placement.columns == Affine{}.columns;
}

}  // namespace raylab
