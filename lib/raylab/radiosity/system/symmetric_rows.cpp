#include "raylab/radiosity/system/symmetric_rows.h"

#include "raylab/radiosity/system/for_each_row.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace raylab {

namespace {

constexpr int max_rounds = 200;
constexpr double close_enough = 1e-13;

void average_pairs(FormFactors& form_factors, std::span<const double> areas) {
    for_each_pair(form_factors.patches(), [&](std::size_t i, std::size_t j) {
        const double mean = (areas[i] * form_factors.at(i, j) + areas[j] * form_factors.at(j, i)) / 2;
        form_factors.at(i, j) = mean / areas[i];
        form_factors.at(j, i) = mean / areas[j];
    });
}

// sum_j d_i F_ij d_j of every patch.
std::vector<double> scaled_sums(const FormFactors& form_factors, const std::vector<double>& d, int threads) {
    std::vector<double> sums(d.size());
    for_each_row(d.size(), threads, [&](std::size_t i) {
        const auto row = form_factors.row(i);
        sums[i] = d[i] * std::inner_product(row.begin(), row.end(), d.begin(), 0.0);
    });
    return sums;
}

// The fixed point of d_i = min(limit_i, d_i / sqrt(sum_i)); the root, because a neighbour's d moves the same sum.
std::vector<double> scales(const FormFactors& form_factors, double form_factor_error, int threads) {
    std::vector<double> d(form_factors.patches(), 1.0);
    std::vector<double> limit;
    for (const double sum : each_row_sum(form_factors, threads))
        limit.push_back(sum >= 1 - form_factor_error ? 1 + form_factor_error : 1);
    double moved = 1;
    for (int round = 0; round < max_rounds && moved > close_enough; ++round) {
        const std::vector<double> sums = scaled_sums(form_factors, d, threads);
        moved = 0;
        for (std::size_t i = 0; i < d.size(); ++i) {
            if (!(sums[i] > 0)) continue;
            const double next = std::min(limit[i], d[i] / std::sqrt(sums[i]));
            moved = std::max(moved, std::abs(next - d[i]));
            d[i] = next;
        }
    }
    // What the rounds have left above 1: a row that is made smaller makes no other larger.
    for (std::size_t i = 0; i < d.size(); ++i) {
        const auto row = form_factors.row(i);
        d[i] /= std::max(1.0, d[i] * std::inner_product(row.begin(), row.end(), d.begin(), 0.0));
    }
    return d;
}

}  // namespace

SymmetricRows symmetric_rows(FormFactors form_factors, std::span<const double> areas, double form_factor_error,
                             int threads) {
    const RowSums before = row_sums(form_factors, threads);
    average_pairs(form_factors, areas);
    std::vector<double> d = scales(form_factors, form_factor_error, threads);
    for_each_row(d.size(), threads, [&](std::size_t i) {
        const auto row = form_factors.row(i);
        for (std::size_t j = 0; j < d.size(); ++j) row[j] *= d[i] * d[j];
    });
    const RowSums after = row_sums(form_factors, threads);
    return {std::move(form_factors), std::move(d), before, after};
}

}  // namespace raylab
