#pragma once

#include "raylab/geometry/vector.h"
#include "raylab/sampling/chi_square.h"
#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace raylab {

/// Counts of directions in cells: those with z >= `lowest`, in rings that are divided around z and become lower towards
/// z, where lobes are narrow. All others, and samples that have no direction, are one more cell.
class DirectionCells {
public:
    explicit DirectionCells(double lowest = -1, int rings = 16, int sectors = 16)
        : lowest_(lowest), rings_(rings), sectors_(sectors), counts_(static_cast<std::size_t>(rings * sectors + 1)) {}

    void add(const Vec3d& direction) { ++counts_[cell(direction)]; }
    void add_none() { ++counts_.back(); }

    /// The integral of a density, per steradian, over each cell, by the midpoints of 16 x 16 parts; the rest to 1 is
    /// that of the last cell.
    template <class Density>
    std::vector<double> integrals(const Density& density) const {
        constexpr int parts = 16;
        const double step = 1.0 / (rings_ * parts), width = 2 * std::numbers::pi / (sectors_ * parts);
        std::vector<double> sums(counts_.size());
        double all = 0;
        for (int i = 0; i < rings_ * parts; ++i)
            for (int k = 0; k < sectors_ * parts; ++k) {
                RandomSequence random(97, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(k));
                const double share = (i + random.next()) * step, height = (1 - lowest_) * 2 * share * step;
                const double below = (1 - lowest_) * share * share, across = std::sqrt(below * (2 - below)),
                             turn = (k + random.next()) * width;
                const double part =
                    density(Vec3d{across * std::cos(turn), across * std::sin(turn), 1 - below}) * height * width;
                sums[static_cast<std::size_t>(i / parts * sectors_ + k / parts)] += part;
                all += part;
            }
        sums.back() = std::max(0.0, 1 - all);
        return sums;
    }

    /// The chi-square test of the directions against such integrals, given how many samples have one.
    double p_value(std::vector<double> integrals) const {
        constexpr double unseen = 1e-8;  // of a cell that an edge cuts, perhaps: none of its 256 directions is inside
        double counted = 0, all = 0;
        for (std::size_t i = 0; i + 1 < counts_.size(); ++i) {
            counted += static_cast<double>(counts_[i]);
            all += integrals[i] += unseen;
        }
        for (double& integral : integrals) integral *= counted / all;
        return chi_square_p_value(std::span(counts_).first(counts_.size() - 1),
                                  std::span(integrals).first(counts_.size() - 1));
    }

    /// The share of samples without a direction in the cells.
    double share_of_none() const {
        double trials = 0;
        for (const std::uint64_t count : counts_) trials += static_cast<double>(count);
        return static_cast<double>(counts_.back()) / trials;
    }

private:
    std::size_t cell(const Vec3d& direction) const {
        const double below = (direction.x * direction.x + direction.y * direction.y) / (1 + direction.z);  // 1 - z
        const double from_top = direction.z > 0 ? below : 1 - direction.z;
        const int ring = static_cast<int>(std::sqrt(from_top / (1 - lowest_)) * rings_);
        if (ring >= rings_) return lowest_ > -1 ? counts_.size() - 1 : counts_.size() - 2;
        const double turn = std::atan2(direction.y, direction.x) / (2 * std::numbers::pi);
        const int sector = std::min(sectors_ - 1, static_cast<int>((turn < 0 ? turn + 1 : turn) * sectors_));
        return static_cast<std::size_t>(ring * sectors_ + sector);
    }

    double lowest_;
    int rings_, sectors_;
    std::vector<std::uint64_t> counts_;
};

}  // namespace raylab
