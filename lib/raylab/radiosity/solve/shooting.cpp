#include "raylab/radiosity/solve/methods.h"
#include "raylab/radiosity/solve/residual.h"
#include "raylab/radiosity/solve/shooting_step.h"
#include "raylab/radiosity/system/row_sums.h"

namespace raylab {

// Of what has been shot all patches have received their share, so B - unshot = E + rho F (B - unshot) - unshot, and the
// residual of B is rho F unshot.
Solution by_shooting(const RadiositySystem& system, const SolverOptions& options) {
    const Color remains = contraction(system, options.threads);
    Solution solution{.solver = "shooting", .radiosity = system.emission, .unshot = system.emission};
    while (system.patches() > 0 && solution.iterations < options.iterations) {
        shooting_step(system, solution.radiosity, solution.unshot);
        ++solution.iterations;
        const double residual = relative(remains * largest_of(solution.unshot), largest_of(solution.radiosity));
        solution.residuals.push_back(residual);
        if (options.watch) options.watch({solution.iterations, residual, solution.radiosity, solution.unshot});
        if (residual <= options.residual) break;
    }
    return solution;
}

}  // namespace raylab
