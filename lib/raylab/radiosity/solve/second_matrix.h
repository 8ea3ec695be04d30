#pragma once

#include "raylab/radiosity/solve/solver.h"

namespace raylab {

/// The memory of a direct method: a matrix as large as the form factors, in which it eliminates. Sweeps and shots need
/// none.
MemoryNeed second_matrix_need(const RadiositySystem& system);

/// Throws an Error where that exceeds the limit.
void check_second_matrix(const RadiositySystem& system, const SolverOptions& options);

}  // namespace raylab
