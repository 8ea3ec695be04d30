#pragma once

#include "raylab/sampling/pattern/fraction.h"
#include "raylab/sampling/pattern/jittered_point.h"
#include "raylab/sampling/pattern/permuted_index.h"
#include "raylab/sampling/random.h"

#include <array>
#include <cmath>
#include <cstdint>

// Patterns with one sample in each of `count` cells, for any count. `key` chooses which sample has which cell, and the
// random bits `inside` where in its cell it lies.

namespace raylab {

/// In one dimension: equal intervals.
inline double jittered_number(std::uint32_t index, std::uint32_t count, std::uint64_t key, std::uint32_t inside) {
    return in_cell(permuted_index(index, count, key), fraction(inside), count);
}

/// In two dimensions: cells of equal area, as close to squares as the count allows.
inline std::array<double, 2> jittered_pair(std::uint32_t index, std::uint32_t count, std::uint64_t key,
                                           std::uint64_t inside) {
    return jittered_point(permuted_index(index, count, key), count, fraction(low_half(inside)),
                          fraction(high_half(inside)));
}

/// Rows and columns of a grid of count x count cells: each has one sample.
inline std::array<double, 2> n_rooks_pair(std::uint32_t index, std::uint32_t count, std::uint64_t key,
                                          std::uint64_t inside) {
    return {jittered_number(index, count, key, low_half(inside)),
            jittered_number(index, count, mixed(~key), high_half(inside))};
}

/// Jittered samples that are n-rooks too: within their cells, those of a column stand at different x, and those of a
/// row at different y, in an order that all columns and all rows share (Kensler, "Correlated Multi-Jittered Sampling",
/// Pixar Technical Memo 13-01, 2013). Where the count is no product of two near numbers, some cells of the last row are
/// empty.
inline std::array<double, 2> multi_jittered_pair(std::uint32_t index, std::uint32_t count, std::uint64_t key,
                                                 std::uint64_t inside) {
    const auto columns = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    const std::uint32_t rows = (count + columns - 1) / columns;
    const std::uint32_t cell = permuted_index(index, count, key);
    const std::uint32_t row = cell / columns, column = cell - row * columns;
    const std::uint64_t other = mixed(~key);
    const double across = permuted_index(column, columns, other), within = permuted_index(row, rows, mixed(other));
    return {in_cell(across, in_cell(within, fraction(low_half(inside)), rows), columns),
            in_cell(cell, fraction(high_half(inside)), count)};
}

}  // namespace raylab
