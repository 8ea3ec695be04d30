#pragma once

#include "raylab/radiosity/radiosity_system.h"

#include <vector>

namespace raylab {

/// sum_j F_ij of every patch i: 1 where patch i sees only other patches, less where it also looks into the void.
std::vector<double> each_row_sum(const FormFactors& form_factors, int threads);

/// The row sums in short; all are 1 where there are no patches.
struct RowSums {
    double least = 1, largest = 1, mean = 1;
};

RowSums row_sums(const FormFactors& form_factors, int threads);

/// max_i rho_i sum_j F_ij in each channel: one reflection leaves at most this share of the largest radiosity. Below 1,
/// every iteration converges.
Color contraction(const RadiositySystem& system, int threads);

}  // namespace raylab
