#pragma once

#include <array>
#include <cstdint>

namespace raylab {

/// A point of one of `count` cells, numbered from 0, of the unit square: they cover it and have equal areas, and none
/// of their sides is longer than 2 / sqrt(count). Two numbers in [0, 1), `u` and `v`, say where in its cell the point
/// lies; its coordinates are in [0, 1). (R. Cook, T. Porter, L. Carpenter: Distributed Ray Tracing, SIGGRAPH 1984.)
std::array<double, 2> jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v);

}  // namespace raylab
