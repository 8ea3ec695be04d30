#include "raylab/radiosity/solve/channel_groups.h"
#include "raylab/radiosity/solve/methods.h"
#include "raylab/radiosity/solve/second_matrix.h"
#include "raylab/radiosity/system/reciprocity.h"
#include "raylab/radiosity/system/row_sums.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

// Nanoseconds of processor time, with 953 patches of the Cornell box on one core: a form factor in a sweep, for all
// channels; and the n^3 / 6 steps of both direct methods, for each matrix. With 391 patches they are the same to a
// fifth; 1941 patches leave the cache, and on a busy machine a sweep takes up to twice as long. What is chosen by them
// took at most a third more than the fastest, of all three and reflectances from .5 to .999.
constexpr double sweep_cost = 0.8;
constexpr double cholesky_cost = 0.17;
constexpr double elimination_cost = 0.30;

}  // namespace

// Gauss and Seidel's sweep gains about what two of Jacobi's do. Over-relaxation gains nearly what Young's theory says,
// although form factors are not ordered as that wants; the factor 1.5 was measured in rooms.
Solution by_cheapest(const RadiositySystem& system, const SolverOptions& options) {
    const auto n = static_cast<double>(system.patches());
    const bool reciprocal = is_reciprocal(reciprocity_error(system.form_factors, system.area));
    const Color rates = contraction(system, options.threads);
    const double rate = std::max({rates.r, rates.g, rates.b});
    const double sweeps = 3 + (reciprocal ? 1.5 * std::log(options.residual) / std::log(over_relaxation(rate) - 1)
                                          : 0.5 * std::log(options.residual) / std::log(rate));
    const auto matrices = static_cast<double>(channel_groups(system).size());
    const double direct = matrices * (reciprocal ? cholesky_cost : elimination_cost) * n * n * n / 6;
    const bool fits = second_matrix_need(system).bytes <= static_cast<double>(options.limit.bytes);
    if (!fits || sweeps * sweep_cost * n * n < direct)
        return reciprocal ? by_relaxation(system, options) : by_gauss_seidel(system, options);
    return reciprocal ? by_cholesky(system, options) : by_elimination(system, options);
}

}  // namespace raylab
