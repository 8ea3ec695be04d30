#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include "raylab/base/unfinished.h"

// Exercise 13. README.md beside this file says what to write; ./raylab check 13 says how it went.
std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    throw Unfinished{};
}
