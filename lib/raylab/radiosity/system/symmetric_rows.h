#pragma once

#include "raylab/radiosity/form_factors.h"
#include "raylab/radiosity/system/row_sums.h"

#include <span>
#include <vector>

namespace raylab {

/// Form factors with exact reciprocity and rows of at most 1, and the row sums of both matrices.
struct SymmetricRows {
    FormFactors form_factors;
    std::vector<double> scales;  // d of each patch
    RowSums before, after;
};

/// Replaces A_i F_ij and A_j F_ji by their mean, and that by d_i d_j times it: the scaling is symmetric, so reciprocity
/// stays. The d are such that rows over 1 come to 1. A row that lies below 1 by no more than the stated error of the
/// form factors comes to 1, too, as far as its neighbours permit; any other row below 1 looks into the void, and keeps
/// d_i = 1.
SymmetricRows symmetric_rows(FormFactors form_factors, std::span<const double> areas, double form_factor_error,
                             int threads);

}  // namespace raylab
