#include "raylab/radiosity/solve/gauss_seidel_sweep.h"
#include "raylab/radiosity/solve/methods.h"
#include "raylab/radiosity/solve/residual.h"
#include "raylab/radiosity/system/for_each_row.h"
#include "raylab/radiosity/system/gathered.h"
#include "raylab/radiosity/system/row_sums.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raylab {

namespace {

// Sweeps until the residual is small enough, from B = E. The residual after a sweep is at most `remains` times the
// largest change.
template <class Sweep>
Solution swept(const std::string& solver, const RadiositySystem& system, const SolverOptions& options,
               const Color& remains, const Sweep& sweep) {
    Solution solution{.solver = solver, .radiosity = system.emission};
    Radiosities before(system.patches());
    while (solution.iterations < options.iterations) {
        std::swap(before, solution.radiosity);
        sweep(std::as_const(before), solution.radiosity);
        ++solution.iterations;
        const double residual =
            relative(remains * largest_change(before, solution.radiosity), largest_of(solution.radiosity));
        solution.residuals.push_back(residual);
        if (options.watch) options.watch({solution.iterations, residual, solution.radiosity, {}});
        if (residual <= options.residual) break;
    }
    return solution;
}

}  // namespace

// The residual before a sweep is the sweep's change d; after it, it is rho F d.
Solution by_jacobi(const RadiositySystem& system, const SolverOptions& options) {
    return swept("jacobi", system, options, contraction(system, options.threads),
                 [&](const Radiosities& before, Radiosities& radiosity) {
                     for_each_row(system.patches(), options.threads, [&](std::size_t i) {
                         const Color arriving = gathered(system.form_factors.row(i), before);
                         radiosity[i] = system.emission[i] + system.reflectance[i] * arriving;
                     });
                 });
}

// Patch i's equation holds when it has been solved; later in the sweep its right side changes by rho_i sum_(j > i) F_ij
// d_j.
Solution by_gauss_seidel(const RadiositySystem& system, const SolverOptions& options) {
    return swept("gauss_seidel", system, options, contraction(system, options.threads),
                 [&](const Radiosities& before, Radiosities& radiosity) {
                     radiosity = before;
                     gauss_seidel_sweep(system, radiosity);
                 });
}

double over_relaxation(double rate) { return 2 / (1 + std::sqrt(std::max(0.0, 1 - rate * rate))); }

// Gauss and Seidel's sweep, except that each patch goes omega times as far. With reciprocity, it converges for any
// omega between 0 and 2 (Ostrowski 1954); this one is Young's, with the bound of Jacobi's rate for that rate.
// A patch's residual when it is visited is (1 - rho_i F_ii) d_i / omega, of which 1 - omega times is left.
Solution by_relaxation(const RadiositySystem& system, const SolverOptions& options) {
    const Color rate = contraction(system, options.threads);
    const Color omega(over_relaxation(rate.r), over_relaxation(rate.g), over_relaxation(rate.b));
    return swept("relaxation", system, options, rate + (omega - 1.0) / omega,
                 [&](const Radiosities& before, Radiosities& radiosity) {
                     radiosity = before;
                     for (std::size_t i = 0; i < system.patches(); ++i) {
                         const auto row = system.form_factors.row(i);
                         const Color& reflectance = system.reflectance[i];
                         const Color residual =
                             system.emission[i] + reflectance * gathered(row, radiosity) - radiosity[i];
                         radiosity[i] += omega * residual / (1.0 - reflectance * row[i]);
                     }
                 });
}

}  // namespace raylab
