#include "raylab/radiosity/solve/solver.h"

#include "catch.h"
#include "systems.h"

#include "raylab/base/error.h"

#include <fmt/format.h>

using namespace raylab;
using Catch::Contains;

TEST_CASE("rows over 1 would give numbers without meaning, and are refused by name") {
    struct Case {
        double row, reflectance, emitter, last_digit;
    };
    for (const auto& [row, reflectance, emitter, last_digit] :
         {Case{1.02, .99, -16.313, .001}, {1.005, .99, 33.698, .001}, {1.02, .98, 417.4, .1}}) {
        CAPTURE(row, reflectance);
        const RadiositySystem system = with_form_factors_times(cube(reflectance), row);
        const Solution believed = solver_named("elimination").run(system, {});
        CHECK_THAT(believed.radiosity[0].r, WithinAbs(emitter, last_digit / 2));
        for (const Solver& solver : solvers())
            CHECK_THROWS_WITH(solve(system, solver),
                              Contains("the radiosity system patch 0: expected form factors whose "
                                       "sum is at most 1 + 1e-09 (RADIOSITY-BLOWUP") &&
                                  Contains("found " + fmt::format("{:.10g}", row)));
    }
}

TEST_CASE("Jacobi's sweeps diverge where rows times reflectance exceed 1") {
    const RadiositySystem system = with_form_factors_times(cube(.99), 1.02);
    const Solution after_1000 = solver_named("jacobi").run(system, {.iterations = 1000});
    const Solution after_2000 = solver_named("jacobi").run(system, {.iterations = 2000});
    CHECK_THAT(after_2000.radiosity[0].r / after_1000.radiosity[0].r, WithinRel(std::pow(1.0098, 1000), 1e-3));
}

TEST_CASE("rows within their stated error of 1 pass, unless their light grows by each reflection") {
    const SolverOptions options{.form_factor_error = 0.03};
    const Solver& solver = solver_named("gauss_seidel");
    CHECK_NOTHROW(solve(with_form_factors_times(cube(.9), 1.02), solver, options));
    CHECK_THROWS_WITH(solve(with_form_factors_times(cube(.99), 1.02), solver, options),
                      "the radiosity system patch 0: expected reflectance times the sum of its form factors below 1 "
                      "(RADIOSITY-BLOWUP), found 0.99 * 1.02");
    RadiositySystem broken = cube(.5);
    broken.form_factors.at(4, 1) = std::nan("");
    CHECK_THROWS_WITH(solve(broken, solver, options), Contains("patch 4") && Contains("found nan"));
}

TEST_CASE("solvers that need reciprocity refuse a matrix without it; the others solve it") {
    RadiositySystem system = cube(0.8);
    system.form_factors.at(2, 4) = 0;
    const Radiosities truth = true_radiosities(system);
    for (const Solver& solver : solvers()) {
        CAPTURE(solver.name);
        if (solver.needs == Solver::Needs::reciprocity)
            CHECK_THROWS_WITH(solve(system, solver),
                              "the radiosity system patch 2: expected A_i F_ij = A_j F_ji for the solver " +
                                  solver.name +
                                  " (symmetric rows have it), found rows and columns that differ by 0.2 of what the "
                                  "patch sends out");
        else
            CHECK(relative_error(solve(system, solver, {.residual = 1e-12}).radiosity, truth) < 1e-10);
    }
}

TEST_CASE("a second matrix that does not fit is refused, and auto does without") {
    const RadiositySystem system = cube(0.5);
    const SolverOptions options{.limit = {200}};
    for (const char* name : {"elimination", "cholesky"})
        CHECK_THROWS_WITH(solve(system, solver_named(name), options),
                          "the radiosity system: expected at most 200 bytes (--memory), found a second matrix, which "
                          "sweeps and shots do without, that needs 288 bytes: 6 x 6 doubles");
    CHECK(solve(system, solver_named("auto"), options).solver == "relaxation");
    CHECK(solve(system, solver_named("auto"), {.limit = {288}}).solver == "cholesky");
}

TEST_CASE("an unknown solver is refused with the known ones") {
    CHECK_THROWS_WITH(solver_named("jakobi"),
                      "expected a solver (elimination, cholesky, jacobi, gauss_seidel, relaxation, shooting, auto), "
                      "found \"jakobi\" (did you mean \"jacobi\"?)");
}
