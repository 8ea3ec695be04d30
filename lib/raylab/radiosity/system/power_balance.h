#pragma once

#include "raylab/radiosity/radiosity_system.h"

#include <span>

namespace raylab {

/// Where the power goes, in watts of each channel. In a solution, emitted = absorbed + lost.
struct PowerBalance {
    Color emitted{0, 0, 0};   // sum_i A_i E_i
    Color absorbed{0, 0, 0};  // sum_i A_i (1 - rho_i) sum_j F_ij B_j
    Color lost{0, 0, 0};      // to the void: sum_i A_i B_i (1 - sum_j F_ij)
    /// (emitted - absorbed - lost) / emitted, of the channel where its magnitude is largest: the error of reciprocity
    /// and of the solution.
    double imbalance = 0;
};

/// The same with the imbalance that its powers have.
PowerBalance with_imbalance(PowerBalance power);

PowerBalance power_balance(const RadiositySystem& system, std::span<const Color> radiosity, int threads);

}  // namespace raylab
