#pragma once

#include "raylab/sampling/chi_square.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// How many points of the unit square fell into each of n x n equal cells.
class CellCounts {
public:
    explicit CellCounts(std::size_t per_side) : per_side_(per_side), counts_(per_side * per_side) {}

    void add(double x, double y) { ++counts_[cell(y) * per_side_ + cell(x)]; }
    void add(const std::array<double, 2>& point) { add(point[0], point[1]); }
    double p_value() const { return chi_square_p_value(counts_); }
    const std::vector<std::uint64_t>& counts() const { return counts_; }

private:
    std::size_t cell(double x) const { return static_cast<std::size_t>(x * static_cast<double>(per_side_)); }

    std::size_t per_side_;
    std::vector<std::uint64_t> counts_;
};

}  // namespace raylab
