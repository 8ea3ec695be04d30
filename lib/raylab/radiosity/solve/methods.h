#pragma once

#include "raylab/radiosity/solve/solver.h"

// The methods of solvers(). Each believes its system; solve() checks it before and measures the result.

namespace raylab {

Solution by_elimination(const RadiositySystem& system, const SolverOptions& options);
Solution by_cholesky(const RadiositySystem& system, const SolverOptions& options);
Solution by_jacobi(const RadiositySystem& system, const SolverOptions& options);
Solution by_gauss_seidel(const RadiositySystem& system, const SolverOptions& options);
Solution by_relaxation(const RadiositySystem& system, const SolverOptions& options);
Solution by_shooting(const RadiositySystem& system, const SolverOptions& options);
Solution by_cheapest(const RadiositySystem& system, const SolverOptions& options);

/// Young's factor of over-relaxation for a rate of Jacobi's sweeps below 1: 2 / (1 + sqrt(1 - rate^2)).
double over_relaxation(double rate);

}  // namespace raylab
