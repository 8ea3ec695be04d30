#include "raylab/radiosity/solve/solver.h"

#include "catch.h"
#include "systems.h"

using namespace raylab;

namespace {

struct CubeTruth {
    double reflectance, emitter, opposite, side;
};

constexpr CubeTruth truths[]{{.5, 1.090909098108, .1817458261078, .1818362689461},
                             {.8, 1.551724153645, .6895510707376, .6896811939044},
                             {.9, 2.372881374826, 1.525310551125, 1.525452018512},
                             {.99, 17.3622704726, 16.52742512772, 16.52757609992}};

}  // namespace

TEST_CASE("every solver finds the brightnesses of a cube with one bright face") {
    for (const CubeTruth& truth : truths)
        for (const Solver& solver : solvers()) {
            CAPTURE(truth.reflectance, solver.name);
            const Solution solution =
                solve(cube(truth.reflectance), solver, {.residual = 1e-12 * (1 - truth.reflectance)});
            for (int channel = 0; channel < 3; ++channel) {
                CHECK_THAT(solution.radiosity[0][channel], WithinAbs(truth.emitter, 1e-9));
                CHECK_THAT(solution.radiosity[1][channel], WithinAbs(truth.opposite, 1e-9));
                for (std::size_t side = 2; side < 6; ++side)
                    CHECK_THAT(solution.radiosity[side][channel], WithinAbs(truth.side, 1e-9));
            }
            CHECK(solution.error_bound < 2e-12);
        }
}

// Published are the iterations after which the error, relative to the largest radiosity, is at most 1e-10. The solvers
// do not know the error but a bound of it. Jacobi's is tight: uniform reflectance in a closed room leaves the same
// share of all that a sweep changes. Of Gauss and Seidel's changes, and of what is unshot, the largest patch is not the
// mean.
TEST_CASE("a cube takes the published numbers of iterations, and few more until the bound says so") {
    struct Count {
        const char* solver;
        double reflectance;
        int published, ours;
    };
    for (const auto& [name, reflectance, published, ours] : {Count{"jacobi", .5, 31, 31},
                                                             {"jacobi", .8, 100, 100},
                                                             {"jacobi", .9, 215, 215},
                                                             {"jacobi", .99, 2286, 2286},
                                                             {"gauss_seidel", .5, 18, 18},
                                                             {"gauss_seidel", .8, 52, 54},
                                                             {"gauss_seidel", .9, 110, 113},
                                                             {"gauss_seidel", .99, 1145, 1180},
                                                             {"shooting", .5, 98, 101},
                                                             {"shooting", .8, 305, 315},
                                                             {"shooting", .9, 650, 670},
                                                             {"shooting", .99, 6865, 7073}}) {
        CAPTURE(name, reflectance);
        const RadiositySystem system = cube(reflectance);
        const Radiosities truth = true_radiosities(system);
        int needed = 0;
        const auto watch = [&](const SolverStep& step) {
            const Radiosities now(step.radiosity.begin(), step.radiosity.end());
            if (needed == 0 && relative_error(now, truth) <= 1e-10) needed = step.iteration;
        };
        const Solution solution =
            solve(system, solver_named(name), {.residual = 1e-10 * (1 - reflectance), .watch = watch});
        CHECK(needed == published);
        CHECK(solution.iterations == ours);
        CHECK(solution.error_bound <= 1e-10 * (1 + 1e-4));
    }
}

TEST_CASE("over-relaxation needs an eighth of the sweeps where reflectances are next to 1") {
    const auto sweeps = [](const char* name, double reflectance) {
        return solve(cube(reflectance), solver_named(name), {.residual = 1e-10 * (1 - reflectance)}).iterations;
    };
    CHECK(sweeps("relaxation", .5) == 14);
    CHECK(sweeps("relaxation", .8) == 27);
    CHECK(sweeps("relaxation", .9) == 41);
    CHECK(sweeps("relaxation", .99) == 140);
}
