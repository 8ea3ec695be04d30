#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"
#include "raylab/radiosity/solve/methods.h"
#include "raylab/radiosity/solve/solver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace raylab {

const std::vector<Solver>& solvers() {
    using Needs = Solver::Needs;
    static const std::vector<Solver> all{
        {"elimination", "Gauss's, with pivots: Eigen's PartialPivLU", Needs::nothing, by_elimination},
        {"cholesky", "Cholesky's, of the symmetric system: Eigen's LLT", Needs::reciprocity, by_cholesky},
        {"jacobi", "Jacobi 1845; each sweep adds one reflection", Needs::nothing, by_jacobi},
        {"gauss_seidel", "Seidel 1874; gathering of Cohen and Greenberg, SIGGRAPH 85", Needs::nothing, by_gauss_seidel},
        {"relaxation", "successive over-relaxation: Young 1954; Gortler, Cohen and Slusallek, CG&A 14(6) 1994",
         Needs::reciprocity, by_relaxation},
        {"shooting",
         "progressive refinement: Cohen, Chen, Wallace and Greenberg, SIGGRAPH 88, which is Southwell's "
         "relaxation",
         Needs::reciprocity, by_shooting},
        {"auto", "the one of these that takes least time", Needs::nothing, by_cheapest},
    };
    return all;
}

const Solver& solver_named(const std::string& name) {
    std::vector<std::string> names;
    for (const Solver& solver : solvers()) {
        if (solver.name == name) return solver;
        names.push_back(solver.name);
    }
    throw Error(fmt::format("expected a solver ({}), found {}", fmt::join(names, ", "), with_suggestion(name, names)));
}

}  // namespace raylab
