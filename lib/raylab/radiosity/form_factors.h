#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace raylab {

/// The form factors of n patches: F_ij is the share of what patch i sends out that arrives at patch j. A row is a
/// patch's view of all others; one value serves all colour channels.
class FormFactors {
public:
    explicit FormFactors(std::size_t patches) : patches_(patches), values_(patches * patches) {}

    std::size_t patches() const { return patches_; }
    std::span<double> row(std::size_t from) { return {values_.data() + from * patches_, patches_}; }
    std::span<const double> row(std::size_t from) const { return {values_.data() + from * patches_, patches_}; }
    double& at(std::size_t from, std::size_t to) { return values_[from * patches_ + to]; }
    double at(std::size_t from, std::size_t to) const { return values_[from * patches_ + to]; }

private:
    std::size_t patches_;
    std::vector<double> values_;
};

}  // namespace raylab
