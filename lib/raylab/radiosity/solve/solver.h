#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/radiosity/radiosity_system.h"

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace raylab {

/// Where a method stands after an iteration; the spans are valid during the call alone.
struct SolverStep {
    int iteration;    // from 1: sweeps, or patches that shot
    double residual;  // as in Solution::residuals
    std::span<const Color> radiosity;
    std::span<const Color> unshot;  // of shooting; else empty
};

struct SolverOptions {
    double residual = 1e-9;           // a method ends when its residual is at most this ...
    int iterations = 1'000'000;       // ... or after so many iterations
    double form_factor_error = 1e-9;  // the stated error of a row's sum: a row may exceed 1 by this much
    int threads = 0;                  // 0: all cores; the bits of the answer do not depend on it
    MemoryLimit limit = {};           // of what a method takes beside the form factors
    std::function<void(const SolverStep&)> watch = {};  // called after every iteration
};

/// What a method made of a system. The residual is max_i |E_i + rho_i sum_j F_ij B_j - B_i| / max_i |B_i|, of the
/// colour channel where that is largest.
struct Solution {
    std::string solver;  // the method that was used
    Radiosities radiosity;
    Radiosities unshot = {};  // of shooting: the part of the radiosity that no other patch has received yet
    int iterations = 0;       // of direct methods 0
    /// After each iteration a bound of the residual, from what the iteration changed: this costs nothing, where the
    /// residual itself would cost as much as another iteration.
    std::vector<double> residuals = {};
    double residual = 0;  // of the result, measured
    /// No radiosity is further than this from the exact solution, relative to the largest of its channel: the residual
    /// over 1 - max_i rho_i sum_j F_ij, since the inverse of I - rho F is the sum of its powers.
    double error_bound = std::numeric_limits<double>::infinity();
};

/// A method from the literature that solves the radiosity equation.
struct Solver {
    enum class Needs { nothing, reciprocity };

    std::string name;
    std::string source;
    Needs needs;
    /// The method as published: it believes any system.
    std::function<Solution(const RadiositySystem&, const SolverOptions&)> run;
};

/// Elimination, Cholesky's, Jacobi's and Gauss and Seidel's, over-relaxation, shooting, and `auto`, which is the one of
/// them that takes least time.
const std::vector<Solver>& solvers();

/// An Error lists the known ones.
const Solver& solver_named(const std::string& name);

/// Solves the system and measures the residual of what came out. It throws an Error for a system whose answer would be
/// nonsense or that the method cannot solve (check_solvable()).
Solution solve(const RadiositySystem& system, const Solver& solver, const SolverOptions& options = {});

}  // namespace raylab
