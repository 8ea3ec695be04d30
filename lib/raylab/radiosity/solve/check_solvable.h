#pragma once

#include "raylab/radiosity/solve/solver.h"

namespace raylab {

/// Throws an Error where a row of form factors exceeds 1 by more than their stated error or, times the reflectance,
/// reaches 1: such patches send out more light than they have, iterations diverge, and a direct method returns numbers
/// without meaning. It also throws where the solver needs reciprocity, A_i F_ij = A_j F_ji, and the matrix has none.
void check_solvable(const RadiositySystem& system, const Solver& solver, const SolverOptions& options);

}  // namespace raylab
