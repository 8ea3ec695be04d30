#pragma once

#include <vector>

namespace raylab {

/// A point of the unit circle.
struct Angle {
    double cosine, sine;
};

/// 2^levels points around the unit circle, levels >= 2, by halving angles: cos and sin are rounded otherwise by every C
/// library.
std::vector<Angle> circle(int levels);

}  // namespace raylab
