#include "raylab/radiosity/system/row_sums.h"

#include "raylab/radiosity/system/for_each_row.h"

#include <algorithm>
#include <numeric>

namespace raylab {

std::vector<double> each_row_sum(const FormFactors& form_factors, int threads) {
    std::vector<double> sums(form_factors.patches());
    for_each_row(sums.size(), threads, [&](std::size_t i) {
        const auto row = form_factors.row(i);
        sums[i] = std::accumulate(row.begin(), row.end(), 0.0);
    });
    return sums;
}

RowSums row_sums(const FormFactors& form_factors, int threads) {
    const std::vector<double> sums = each_row_sum(form_factors, threads);
    if (sums.empty()) return {};
    const auto [least, largest] = std::ranges::minmax(sums);
    return {least, largest, std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(sums.size())};
}

Color contraction(const RadiositySystem& system, int threads) {
    const std::vector<double> sums = each_row_sum(system.form_factors, threads);
    Color largest(0);
    for (std::size_t i = 0; i < sums.size(); ++i) largest = glm::max(largest, system.reflectance[i] * sums[i]);
    return largest;
}

}  // namespace raylab
