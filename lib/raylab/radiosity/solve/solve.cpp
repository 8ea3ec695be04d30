#include "raylab/radiosity/solve/check_solvable.h"
#include "raylab/radiosity/solve/residual.h"
#include "raylab/radiosity/solve/solver.h"
#include "raylab/radiosity/system/row_sums.h"

namespace raylab {

Solution solve(const RadiositySystem& system, const Solver& solver, const SolverOptions& options) {
    check_solvable(system, solver, options);
    Solution solution = solver.run(system, options);
    const Color residual = residual_of(system, solution.radiosity, options.threads);
    const Color largest = largest_of(solution.radiosity);
    solution.residual = relative(residual, largest);
    solution.error_bound = relative(residual / (1.0 - contraction(system, options.threads)), largest);
    return solution;
}

}  // namespace raylab
