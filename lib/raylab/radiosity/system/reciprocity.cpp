#include "raylab/radiosity/system/reciprocity.h"

#include "raylab/radiosity/system/for_each_row.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace raylab {

Reciprocity reciprocity_error(const FormFactors& form_factors, std::span<const double> areas) {
    const std::size_t n = form_factors.patches();
    Reciprocity error;
    std::vector<double> difference(n);
    for_each_pair(n, [&](std::size_t i, std::size_t j) {
        const double there = areas[i] * form_factors.at(i, j);
        const double back = areas[j] * form_factors.at(j, i);
        const double apart = std::abs(there - back);
        if (apart > 0) error.largest_relative = std::max(error.largest_relative, apart / std::max(there, back));
        difference[i] += apart;
        difference[j] += apart;
    });
    for (std::size_t i = 0; i < n; ++i) {
        const double share = difference[i] / areas[i];
        if (share > error.largest_share) error.largest_share = share, error.patch = i;
    }
    return error;
}

bool is_reciprocal(const Reciprocity& error) { return error.largest_share <= 1e-9; }

}  // namespace raylab
