// hint: cell_ignored
// The two numbers are the point.
#include "raylab/sampling/pattern/jittered_point.h"

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    return {u, v};
}
