#pragma once

#include <numbers>

namespace raylab {

inline constexpr double degree = std::numbers::pi / 180;  // in radians

}  // namespace raylab
