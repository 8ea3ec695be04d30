#include "raylab/radiosity/solve/residual.h"
#include "raylab/radiosity/solve/solver.h"

#include "catch.h"
#include "systems.h"

using namespace raylab;

TEST_CASE("all solvers agree with elimination in long doubles on any system") {
    for (const std::size_t patches : {1u, 2u, 3u, 7u, 20u, 65u})
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            const RadiositySystem system = any_system(patches, seed % 2 == 0 ? 1 : 0.6, seed);
            const Radiosities truth = true_radiosities(system);
            for (const Solver& solver : solvers()) {
                CAPTURE(patches, seed, solver.name);
                const Solution solution = solve(system, solver, {.residual = 1e-13});
                CHECK(relative_error(solution.radiosity, truth) < 1e-11);
                CHECK(solution.residual <= 1e-13);
            }
        }
}

TEST_CASE("the stated bounds hold: of the residual after each iteration, and of the error at the end") {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const RadiositySystem system = any_system(12, 1, seed);
        const Radiosities truth = true_radiosities(system);
        for (const Solver& solver : solvers()) {
            CAPTURE(seed, solver.name);
            int broken = 0;
            const SolverOptions options{.residual = 1e-4, .watch = [&](const SolverStep& step) {
                                            const double residual = relative(residual_of(system, step.radiosity, 1),
                                                                             largest_of(step.radiosity));
                                            if (!(residual <= step.residual * (1 + 1e-12))) ++broken;
                                        }};
            const Solution solution = solve(system, solver, options);
            CHECK(broken == 0);
            CHECK(static_cast<int>(solution.residuals.size()) == solution.iterations);
            CHECK(solution.residual <= 1e-4);
            const Color largest = largest_of(truth) / largest_of(solution.radiosity);
            const double share =
                std::max({largest.r, largest.g, largest.b});  // the bound is relative to what was found
            CHECK(relative_error(solution.radiosity, truth) * share <= solution.error_bound + 1e-15);
        }
    }
}

TEST_CASE("no patches, one patch, no light, nothing that reflects") {
    for (const Solver& solver : solvers()) {
        CAPTURE(solver.name);
        CHECK(solve(dark_system({}, 0, FormFactors(0)), solver).radiosity.empty());

        RadiositySystem alone = dark_system({2}, 0.5, FormFactors(1));
        alone.emission[0] = Color(3);
        CHECK(solve(alone, solver).radiosity[0] == Color(3));

        const Solution unlit = solve(cube(0.5), solver);
        CHECK(unlit.error_bound < 1e-8);
        const Solution dark = solve(dark_system({1, 2, 3}, 0.5, FormFactors(3)), solver);
        CHECK(dark.radiosity == Radiosities(3, Color(0)));
        CHECK(dark.residual == 0);
        CHECK(dark.error_bound == 0);

        const Solution black = solve(cube(0), solver);
        CHECK(black.radiosity == cube(0).emission);
    }
}

TEST_CASE("channels are independent: a black one stays as it is emitted, the others are as if they were alone") {
    RadiositySystem system = cube(0.8);
    for (Color& reflectance : system.reflectance) reflectance.g = 0;
    system.emission[3] = Color(0, 2, 1);
    for (const Solver& solver : solvers()) {
        CAPTURE(solver.name);
        const Radiosities all = solve(system, solver, {.residual = 1e-14}).radiosity;
        for (std::size_t i = 0; i < 6; ++i) CHECK_THAT(all[i].g, WithinAbs(system.emission[i].g, 1e-13));
        RadiositySystem blue = cube(0.8);
        blue.emission[3].b = 1;
        const Radiosities expected = solve(blue, solver, {.residual = 1e-14}).radiosity;
        for (std::size_t i = 0; i < 6; ++i) CHECK_THAT(all[i].b, WithinAbs(expected[i].b, 1e-12));
    }
}

TEST_CASE("a solver ends after the iterations that it is given, and says what is left") {
    for (const char* name : {"jacobi", "gauss_seidel", "relaxation", "shooting"}) {
        CAPTURE(name);
        const Solution solution = solve(cube(0.99), solver_named(name), {.residual = 1e-10, .iterations = 3});
        CHECK(solution.iterations == 3);
        CHECK(solution.residual > 1e-3);
        CHECK(solution.error_bound > 0.1);
    }
}

TEST_CASE("auto eliminates a few patches and sweeps over many, unless reflectances are next to 1") {
    CHECK(solve(cube(0.5), solver_named("auto")).solver == "cholesky");
    CHECK(solve(any_system(400, 0.9, 1), solver_named("auto")).solver == "relaxation");
    CHECK(solve(sphere(std::vector<double>(200, 1.0), 0.9999), solver_named("auto")).solver == "cholesky");
    RadiositySystem one_sided = cube(0.5);
    one_sided.form_factors.at(0, 1) = 0;
    CHECK(solve(one_sided, solver_named("auto")).solver == "elimination");
    RadiositySystem large_and_one_sided = any_system(400, 0.9, 1);
    large_and_one_sided.form_factors.at(0, 1) += 1e-3;
    CHECK(solve(large_and_one_sided, solver_named("auto")).solver == "gauss_seidel");
}
