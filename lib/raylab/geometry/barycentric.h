#pragma once

namespace raylab {

/// Interpolates the values at a triangle's vertices (colours, normals, positions) at the point with weights u of b, v
/// of c. A normal mixed this way must be made unit again.
template <class Value, class Weight>
Value interpolate(const Value& a, const Value& b, const Value& c, Weight u, Weight v) {
    return (Weight(1) - u - v) * a + u * b + v * c;
}

}  // namespace raylab
