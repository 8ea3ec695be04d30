#pragma once

#include "raylab/radiosity/radiosity_system.h"

#include <cstddef>
#include <span>

namespace raylab {

/// How far a matrix of form factors is from A_i F_ij = A_j F_ji: what i sends to j at the same radiosity, j sends to i.
struct Reciprocity {
    double largest_relative = 0;  // |A_i F_ij - A_j F_ji| / max(A_i F_ij, A_j F_ji) of the worst pair
    double largest_share = 0;     // sum_j |A_i F_ij - A_j F_ji| / A_i of the worst patch: a share of what it sends out
    std::size_t patch = 0;        // that patch
};

Reciprocity reciprocity_error(const FormFactors& form_factors, std::span<const double> areas);

/// Whether the matrix has reciprocity but for rounding: no patch's share exceeds 1e-9, which lies far above what
/// rounding leaves and far below what an estimate of form factors reaches.
bool is_reciprocal(const Reciprocity& error);

}  // namespace raylab
