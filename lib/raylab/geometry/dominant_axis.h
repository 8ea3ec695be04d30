#pragma once

#include <cmath>

namespace raylab {

/// The axis (0, 1, 2) along which v is longest in magnitude; x before y before z where equal. Dropping it keeps the
/// most of a polygon's area.
template <class Vector>
int dominant_axis(const Vector& v) {
    const auto x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
    if (x >= y && x >= z) return 0;
    return y >= z ? 1 : 2;
}

/// The two axes beside `axis`, in cyclic order, so that their orientation is kept.
struct AxisPair {
    int first, second;
};

constexpr AxisPair other_axes(int axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

}  // namespace raylab
