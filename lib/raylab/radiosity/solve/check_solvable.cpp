#include "raylab/radiosity/solve/check_solvable.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/system/reciprocity.h"
#include "raylab/radiosity/system/row_sums.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

Place place_of(std::size_t patch) { return {"the radiosity system", 0, fmt::format("patch {}", patch)}; }

}  // namespace

void check_solvable(const RadiositySystem& system, const Solver& solver, const SolverOptions& options) {
    const std::vector<double> sums = each_row_sum(system.form_factors, options.threads);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Color& reflectance = system.reflectance[i];
        const double brightest = std::max({reflectance.r, reflectance.g, reflectance.b});
        if (!(sums[i] <= 1 + options.form_factor_error))
            throw Error(place_of(i),
                        fmt::format("form factors whose sum is at most 1 + {:.3g} (RADIOSITY-BLOWUP; symmetric rows "
                                    "are scaled to at most 1)",
                                    options.form_factor_error),
                        fmt::format("{:.10g}", sums[i]));
        if (!(brightest * sums[i] < 1))
            throw Error(place_of(i), "reflectance times the sum of its form factors below 1 (RADIOSITY-BLOWUP)",
                        fmt::format("{:.10g} * {:.10g}", brightest, sums[i]));
    }
    if (solver.needs != Solver::Needs::reciprocity) return;
    const Reciprocity error = reciprocity_error(system.form_factors, system.area);
    if (!is_reciprocal(error))
        throw Error(
            place_of(error.patch),
            fmt::format("A_i F_ij = A_j F_ji for the solver {} (symmetric rows have it)", solver.name),
            fmt::format("rows and columns that differ by {:.3g} of what the patch sends out", error.largest_share));
}

}  // namespace raylab
